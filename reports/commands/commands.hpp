#pragma once

#include <CLI/App.hpp>
#include <functional>

namespace porowave::reports {

/// A subcommand adds itself to the program; `run` is set to what it does when it was chosen.
/// The function returns the exit code.
using Command = std::function<int()>;

/// Of a run that broke down numerically.
inline constexpr int exit_broke_down = 4;

void add_reference_command(CLI::App& program, Command& run);
void add_waves_command(CLI::App& program, Command& run);
void add_solve_command(CLI::App& program, Command& run);
void add_stability_command(CLI::App& program, Command& run);
void add_grade_command(CLI::App& program, Command& run);
void add_explain_command(CLI::App& program, Command& run);
void add_sweep_command(CLI::App& program, Command& run);
void add_status_command(CLI::App& program, Command& run);
void add_merge_command(CLI::App& program, Command& run);
void add_gate_command(CLI::App& program, Command& run);
void add_report_command(CLI::App& program, Command& run);
void add_demo_command(CLI::App& program, Command& run);

}  // namespace porowave::reports
