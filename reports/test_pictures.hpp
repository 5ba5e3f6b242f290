#pragma once

#include <boost/test/unit_test.hpp>
#include <string>

#include "reports/test_directory.hpp"

namespace porowave::tests {

inline bool is_svg(const std::string& text) {
  return text.rfind("<?xml", 0) == 0 && text.ends_with("</svg>\n\n");
}

inline bool is_png(const std::string& text) {
  const std::string end("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  return text.rfind("\x89PNG\r\n\x1a\n", 0) == 0 && text.ends_with(end);
}

/// That the four files of a figure are there and can be read.
inline void check_pictures(const std::filesystem::path& directory, const std::string& name) {
  BOOST_TEST_CONTEXT(name) {
    BOOST_TEST(is_svg(text_of(directory / (name + ".svg"))));
    BOOST_TEST(is_png(text_of(directory / (name + ".png"))));
    BOOST_TEST(contains(text_of(directory / (name + ".gp")), "plot "));
    BOOST_TEST(text_of(directory / (name + ".dat")).rfind("# ", 0) == 0u);
  }
}

}  // namespace porowave::tests
