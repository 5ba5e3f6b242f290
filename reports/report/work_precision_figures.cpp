#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/report/figure_parts.hpp"
#include "reports/report/text_forms.hpp"

namespace porowave::reports {

namespace {

constexpr std::size_t most_named = 14;
constexpr std::size_t most_curves = 16;
/// The front's next name has an error lower by this factor at least.
constexpr double named_gain = 1.5;
/// Errors beyond this are of runs that went wrong; the axis leaves them out.
constexpr double largest_of_axis = 30.0;

std::string member_name(const StudyTable& table, const FrontMember& member) {
  return method_name(table, member.group, member.level);
}

/// Of every member of the front its number in the figure's list, 0 if it is not named.
std::vector<std::size_t> numbers_of(const std::vector<FrontMember>& front) {
  std::vector<std::size_t> numbers(front.size(), 0);
  std::size_t next = 1;
  double last = HUGE_VAL;
  for (std::size_t i = 0; i < front.size() && next <= most_named; ++i) {
    const bool end = i + 1 == front.size();
    if (!end && next > 1 && (front[i].error * named_gain > last || next == most_named)) continue;
    numbers[i] = next++;
    last = front[i].error;
  }
  return numbers;
}

void add_front(Figure& figure, const StudyTable& table, const std::vector<FrontMember>& front) {
  const auto numbers = numbers_of(front);
  std::size_t named = 0;
  for (std::size_t i = 0; i < front.size(); ++i) {
    figure.data += fmt::format("1,0,{:.4e},{:.4e},{},{}\n", front[i].cpu_seconds, front[i].error,
                               numbers[i], csv_field(member_name(table, front[i])));
    if (numbers[i] == 0) continue;
    named = std::max(named, numbers[i]);
    add_text(figure, fmt::format("front{}", numbers[i]),
             fmt::format("{:>2}  {:.1e} s  {:.1e}  {}", numbers[i], front[i].cpu_seconds,
                         front[i].error, shortened(member_name(table, front[i]), 60)));
  }
  add_text(figure, "front", fmt::format("{}", named));
}

ReportFigure figure_of(const FigureInput& input, const FigurePart& part,
                       const std::vector<FrontMember>& front, const std::string& name) {
  const StudyTable& table = input.table;
  const FigureAxes axes = figure_axes(table);
  ReportFigure result{{name, "report_work_precision", {}, {}, true}, "Work and precision", {}, {}};
  Figure& figure = result.figure;
  figure.data = "kind,curve,cpu_seconds,error,number,name\n";
  PositiveRange cpu;
  PositiveRange errors;
  for (const std::size_t g : part.groups) {
    const std::size_t curve = std::min(place_on(table.groups[g], axes.curve), most_curves - 1);
    for (std::size_t l = 0; l < input.summaries[g].levels.size(); ++l) {
      const LevelSummary& level = input.summaries[g].levels[l];
      if (level.ended == 0) continue;
      cpu.see(level.cpu_seconds);
      errors.see(level.error);
      figure.data += fmt::format("0,{},{:.4e},{:.4e},0,{}\n", curve + 1, level.cpu_seconds,
                                 level.error, csv_field(member_name(table, {g, l, 0.0, 0.0})));
    }
  }
  add_front(figure, table, front);
  const std::size_t curves = std::min(size_of(table, axes.curve), most_curves);
  for (std::size_t c = 0; c < curves; ++c) {
    const std::string value = value_on(table, axes.curve, c);
    const bool last_of_many = c + 1 == most_curves && size_of(table, axes.curve) > most_curves;
    add_text(figure, fmt::format("legend{}", c + 1),
             last_of_many ? "others" : shortened(value.empty() ? "all cases" : value, 34));
  }
  add_text(figure, "curves", fmt::format("{}", curves));
  add_text(figure, "x_low", real_text(0.6 * cpu.low));
  add_text(figure, "x_high", real_text(1.6 * cpu.high));
  add_text(figure, "y_low", real_text(0.4 * errors.low));
  add_text(figure, "y_high",
           real_text(1.6 * std::min(errors.high, std::max(largest_of_axis, 2.0 * errors.low))));
  add_text(figure, "y_title",
           "relative error (–): " + measure_title(verification::measure_names()[input.measure]));
  const std::string where = described(table, problem_axes(table), part.at);
  const std::string best = member_name(table, front.back());
  add_text(figure, "caption", shortened("Most precise: " + best, 80));
  add_text(
      figure, "subcaption",
      shortened((where.empty() ? "" : where + " · ") + "a mark is the mean over the seeds", 120));
  result.claim = fmt::format(
      "{}{} of {} levels and methods are on the Pareto front: no other is both cheaper and more "
      "precise. Cheapest: {} ({:.1e} s, error {:.2g}). Most precise: {} ({:.1e} s, error {:.2g}).",
      where.empty() ? "" : where + ": ", front.size(),
      std::count(figure.data.begin(), figure.data.end(), '\n') -
          static_cast<std::ptrdiff_t>(front.size()) - 1,
      member_name(table, front.front()), front.front().cpu_seconds, front.front().error, best,
      front.back().cpu_seconds, front.back().error);
  result.alt = "Error against CPU time of a run on logarithmic axes. " + result.claim;
  return result;
}

}  // namespace

std::vector<FrontMember> pareto_front(const std::vector<GroupSummary>& summaries,
                                      const std::vector<std::size_t>& groups) {
  std::vector<FrontMember> all;
  for (const std::size_t g : groups) {
    for (std::size_t l = 0; l < summaries[g].levels.size(); ++l) {
      const LevelSummary& level = summaries[g].levels[l];
      // A method some of whose runs broke down is no choice.
      if (level.ended == 0 || level.ended < level.cases || !(level.cpu_seconds > 0.0)) continue;
      all.push_back({g, l, level.cpu_seconds, level.error});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const FrontMember& a, const FrontMember& b) {
    return std::pair(a.cpu_seconds, a.error) < std::pair(b.cpu_seconds, b.error);
  });
  std::vector<FrontMember> front;
  for (const FrontMember& member : all) {
    if (front.empty() || member.error < front.back().error) front.push_back(member);
  }
  return front;
}

std::vector<ReportFigure> work_precision_figures(const FigureInput& input) {
  std::vector<ReportFigure> figures;
  for (const FigurePart& part : parts_of(input.table, problem_axes(input.table))) {
    if (figures.size() == most_figures) break;
    const auto front = pareto_front(input.summaries, part.groups);
    if (front.empty()) continue;
    figures.push_back(
        figure_of(input, part, front,
                  fmt::format("{}work_precision_{:02}", input.prefix, figures.size() + 1)));
  }
  return figures;
}

}  // namespace porowave::reports
