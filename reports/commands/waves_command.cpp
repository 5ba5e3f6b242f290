#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <sstream>

#include "reference/fronts.hpp"
#include "reference/problem/errors.hpp"
#include "reference/waves.hpp"
#include "reports/commands/commands.hpp"
#include "reports/commands/number_list.hpp"
#include "reports/output_file.hpp"

namespace porowave::reports {

namespace {

struct WavesOptions {
  std::string problem;
  std::string frequency;
  std::string t;
  std::string output;
};

void write_summary(const Problem& problem, const reference::WaveModes& modes, std::ostream& out) {
  const reference::WaveScales scales = reference::wave_scales(problem.material);
  const auto line = [&](const char* what, double value, const char* unit, const char* formula) {
    fmt::print(out, "{:<25}{:>13.6g} {:<6} {}\n", what, value, unit, formula);
  };
  line("P1 speed, frozen", scales.p1, "m/s", "c1, without drag: high frequency, fronts");
  line("P2 speed, frozen", scales.p2, "m/s", "c2");
  line("undrained speed", scales.undrained, "m/s", "sqrt((E + K)/rho), K = K_f/n_f: low frequency");
  line("drained speed", scales.drained, "m/s", "sqrt(E/rho), rho of the mixture");
  line("dry skeleton speed", scales.dry_skeleton, "m/s", "sqrt(E/(n_s rho_s))");
  line("consolidation coefficient", scales.consolidation, "m^2/s", "c_v = kappa/mu E K/(E + K)");
  line("relaxation rate", scales.relaxation_rate, "1/s",
       "theta = n_f^2 mu/kappa (1/(n_s rho_s) + 1/(n_f rho_f))");
  line("characteristic frequency", scales.characteristic_frequency, "Hz", "theta/(2 pi)");
  if (problem.column.length) {
    const double length = *problem.column.length;
    const double crossing = length / scales.p1;
    line("crossing time of P1", crossing, "s", "L/c1");
    line("consolidation time", length * length / scales.consolidation, "s", "L^2/c_v");
    line("dimensionless drag", scales.relaxation_rate * crossing, "", "theta L/c1");
  }
  const bool exchanged = reference::undrained_mode(modes) == 1;
  fmt::print(out, "At low frequency {} becomes the undrained wave, {} diffuses with c_v.\n",
             exchanged ? "P2" : "P1", exchanged ? "P1" : "P2");
}

void write_dispersion(const reference::WaveModes& modes, const std::vector<double>& frequencies,
                      std::ostream& out) {
  out << "frequency,p1_phase_velocity,p1_attenuation,p1_inverse_q,p2_phase_velocity,"
         "p2_attenuation,p2_inverse_q\n";
  for (const double frequency : frequencies) {
    const auto [p1, p2] = reference::dispersion(modes, frequency);
    fmt::print(out, "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", frequency,
               p1.phase_velocity, p1.attenuation, p1.inverse_q, p2.phase_velocity, p2.attenuation,
               p2.inverse_q);
  }
}

void write_fronts(const Problem& problem, const reference::WaveModes& modes,
                  const std::vector<double>& ts, std::ostream& out) {
  out << "t,x,mode,direction,crossings,effective_stress_jump,pore_pressure_jump,"
         "solid_velocity_jump,fluid_velocity_jump,started,kind\n";
  for (const double t : ts) {
    for (const auto& front : reference::fronts_at(problem, modes, t)) {
      const Fields& jump = front.jump;
      fmt::print(out, "{:.17g},{:.17g},{},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{}\n", t,
                 front.x, front.mode == 0 ? "p1" : "p2", front.upwards ? "up" : "down",
                 front.crossings, jump.effective_stress, jump.pore_pressure, jump.solid_velocity,
                 jump.fluid_velocity, front.started, front.of_jump ? "jump" : "onset");
    }
  }
}

int run_waves(const WavesOptions& options) {
  if (!options.frequency.empty() && !options.t.empty()) {
    throw InputError("waves: expected --frequency or --t, not both: they make different tables");
  }
  const Problem problem = load_problem(options.problem);
  const reference::WaveModes modes(problem.material);
  // All of it before any of it is written, as a time may turn out to have too many fronts.
  std::ostringstream table;
  if (!options.frequency.empty()) {
    write_dispersion(modes, parse_positive_list(options.frequency, "--frequency"), table);
  } else if (!options.t.empty()) {
    write_fronts(problem, modes, parse_number_list(options.t, "--t"), table);
  } else {
    write_summary(problem, modes, table);
  }
  if (options.output.empty()) {
    std::cout << table.str();
  } else {
    write_file(options.output, table.str());
    fmt::print("wrote {}\n", options.output);
  }
  return 0;
}

}  // namespace

void add_waves_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<WavesOptions>();
  CLI::App* command = program.add_subcommand(
      "waves", "Wave speeds of a problem, dispersion against frequency, fronts and their jumps");
  command->add_option("problem", options->problem, "Problem file (TOML); a case file will do too")
      ->required();
  command->add_option(
      "--frequency", options->frequency,
      "Frequencies for a table of phase velocity (m/s), attenuation (Np/m) and 1/Q: "
      "FIRST:LAST:COUNT, even in the logarithm, or a comma list, Hz");
  command->add_option("--t", options->t,
                      "Times for a table of fronts: a comma list (or FIRST:LAST:COUNT), s");
  command->add_option("--output", options->output, "File (standard output if absent)");
  command->footer(
      "Without --frequency and --t: speeds, consolidation coefficient, characteristic frequency.\n"
      "A front's jump is the value just behind it less the value just ahead; \"up\" is towards\n"
      "larger x, \"crossings\" are those made before. Kind \"onset\" (jump 0) is the first "
      "arrival\n"
      "of a load that begins without a jump.\n"
      "Example: porowave waves verification/studies/paper_problem.toml --frequency 1e3:1e7:41");
  command->callback([options, &run] { run = [options] { return run_waves(*options); }; });
}

}  // namespace porowave::reports
