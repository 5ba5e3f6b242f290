#include "reports/report/report.hpp"

#include "reports/junit.hpp"
#include "reports/output_file.hpp"
#include "reports/progress.hpp"
#include "reports/report/critical_map.hpp"
#include "reports/report/page.hpp"
#include "reports/report/run_sections.hpp"
#include "reports/report/summary.hpp"
#include "verification/parallel.hpp"

namespace porowave::reports {

namespace fs = std::filesystem;

namespace {

std::vector<const Figure*> all_figures(const ReportContent& content) {
  std::vector<const Figure*> figures;
  for (const StudyReport& study : content.studies) {
    for (const ReportFigure& figure : study.figures) figures.push_back(&figure.figure);
    for (const RunSection& section : study.runs) {
      for (const ReportFigure& figure : section.figures) figures.push_back(&figure.figure);
    }
  }
  return figures;
}

std::vector<fs::path> draw_all(const std::vector<const Figure*>& figures, const fs::path& output) {
  Progress progress("porowave report", static_cast<int>(figures.size()));
  std::vector<std::vector<fs::path>> drawn(figures.size());
  verification::parallel_for(figures.size(),
                             [&](std::size_t i) { drawn[i] = draw(*figures[i], output); });
  std::vector<fs::path> files;
  for (auto& of_figure : drawn) files.insert(files.end(), of_figure.begin(), of_figure.end());
  return files;
}

}  // namespace

std::vector<fs::path> write_report(const ReportOptions& options) {
  ReportContent content = read_report(options);
  const bool runs = options.runs > 0 && !content.studies.empty();
  if (runs || options.map_seconds > 0.0 || !all_figures(content).empty()) require_gnuplot();
  if (!options.junit.empty()) require_writable(options.junit);
  const fs::path output = options.output;
  make_output_directory(output);
  if (runs) add_runs(content);
  if (options.map_seconds > 0.0) add_critical_maps(content);
  const auto figures = all_figures(content);
  std::vector<fs::path> files = draw_all(figures, output);
  const auto write = [&](const std::string& name, const std::string& text) {
    files.push_back(output / name);
    write_file(files.back(), text);
  };
  for (const ResultTable& table : tables_of(content)) {
    write(table.name + ".csv", as_csv(table));
    write(table.name + ".tex", as_latex(table));
  }
  for (std::size_t s = 0; s < content.studies.size(); ++s) {
    const ResultTable cases = cases_table(content, s);
    write(cases.name + ".csv", as_csv(cases));
  }
  if (!options.junit.empty()) {
    files.emplace_back(options.junit);
    write_file(files.back(), junit_of(content.judged_study, *content.verdicts));
  }
  write("summary.md", summary_markdown(content));
  write("index.html", page_html(content, output));
  return files;
}

}  // namespace porowave::reports
