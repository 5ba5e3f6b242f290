#pragma once

#include <filesystem>
#include <vector>

namespace porowave::reports {

/// The paper's study (Chmelnizkij 2023, section 5), small, end to end: its Figures 3, 4 and 5, and
/// the convergence of the scheme under a smooth load. Writes figures (svg, png, gp, dat) and tables
/// (csv) to the directory and returns them in order. Throws EnvironmentError without gnuplot or if
/// the directory cannot be written; both are found out before anything is computed.
std::vector<std::filesystem::path> run_demo(const std::filesystem::path& directory);

}  // namespace porowave::reports
