#include "verification/study/case_identity.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "verification/study/build_identity.hpp"

namespace porowave::verification {

namespace {

__extension__ using Word = unsigned __int128;

constexpr Word basis = (Word{0x6c62272e07bb0142} << 64) | 0x62b821756295c58d;
constexpr Word prime = (Word{1} << 88) | 0x13b;

}  // namespace

std::string text_hash(std::string_view text) {
  Word hash = basis;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= prime;
  }
  return fmt::format("{:016x}{:016x}", static_cast<std::uint64_t>(hash >> 64),
                     static_cast<std::uint64_t>(hash));
}

std::string case_id(std::string_view specification, const solver::Case& scene) {
  std::string text = fmt::format("{}\n{}", numerics_hash(), specification);
  const Load& load = scene.problem.load;
  for (std::size_t i = 0; i < load.times().size(); ++i) {
    text += fmt::format("{},{}\n", load.times()[i], load.values()[i]);
  }
  return text_hash(text);
}

}  // namespace porowave::verification
