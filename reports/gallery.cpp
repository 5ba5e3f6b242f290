// porowave-gallery DIRECTORY: draws the pictures of reference/README.md from what it computes now.

#include <fmt/format.h>

#include <exception>
#include <filesystem>

#include "reports/reference_figures.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "porowave-gallery: expected one directory\n");
    return 2;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    for (const auto& figure :
         {porowave::reports::reference_contours(), porowave::reports::reference_work_precision()}) {
      for (const auto& path : porowave::reports::draw(figure, argv[1])) {
        fmt::print("wrote {}\n", path.string());
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "porowave-gallery: {}\n", error.what());
    return 5;
  }
  return 0;
}
