#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace porowave {

class TomlDocument;

/// What is prescribed at the loaded end x = 0; q(t) is the load.
enum class NearEnd {
  drained_traction,  ///< effective stress -q, pore pressure 0
  sealed_traction,   ///< effective stress - pore pressure = -q, v_s = v_f (impermeable piston)
  fluid_pressure,    ///< effective stress 0, pore pressure q
  velocity,          ///< v_s = v_f = q (rigid piston; q in m/s)
};
inline constexpr std::array<std::string_view, 4> near_end_names = {
    "drained_traction", "sealed_traction", "fluid_pressure", "velocity"};

/// What is prescribed at the far end x = length.
enum class FarEnd {
  rigid_sealed,   ///< v_s = v_f = 0
  rigid_drained,  ///< v_s = 0, pore pressure 0
  free_drained,   ///< effective stress 0, pore pressure 0
  half_space,     ///< no wave comes back
};
inline constexpr std::array<std::string_view, 4> far_end_names = {"rigid_sealed", "rigid_drained",
                                                                  "free_drained", "half_space"};

constexpr std::string_view name(NearEnd end) {
  return near_end_names[static_cast<std::size_t>(end)];
}
constexpr std::string_view name(FarEnd end) {
  return far_end_names[static_cast<std::size_t>(end)];
}

/// A column 0 <= x <= length, loaded at x = 0.
struct Column {
  std::optional<double> length;  ///< m; absent for a half-space, where nothing ends
  NearEnd near = NearEnd::drained_traction;
  FarEnd far = FarEnd::rigid_sealed;
};

/// Reads [column]. A length is required unless far = "half_space", where it is refused.
Column read_column(const TomlDocument& document);

}  // namespace porowave
