#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace porowave::reports {

/// One figure: <name>.gp and <name>.dat beside <name>.svg and <name>.png, so that anyone can
/// restyle it and run `gnuplot <name>.gp` again.
struct Figure {
  std::string name;           ///< file name without ending; letters, digits, - and _ only
  std::string template_name;  ///< which of reports/plots/*.gp draws it
  /// Gnuplot string variables that the template uses; values are escaped here.
  std::vector<std::pair<std::string, std::string>> texts;
  std::string data;  ///< contents of <name>.dat
  /// A figure of a report: its data is a table, <name>.csv, and it is drawn as <name>.pdf as well.
  bool for_paper = false;
  bool animated = false;  ///< <name>.gif as well
  bool as_pdf = false;    ///< <name>.pdf as well, with the data as they are

  std::string data_file() const { return name + (for_paper ? ".csv" : ".dat"); }
  bool has_pdf() const { return for_paper || as_pdf; }
};

/// Writes data and script, runs gnuplot, and returns the files written (svg, png, gp, data, pdf,
/// gif): the same bytes for the same figure, whenever it is drawn. Throws EnvironmentError if
/// gnuplot is missing or fails; then nothing of the figure is left.
std::vector<std::filesystem::path> draw(const Figure& figure,
                                        const std::filesystem::path& directory);

/// Throws EnvironmentError, with the remedy, if there is no gnuplot; call before long work.
void require_gnuplot();

/// A PDF without the dates of its creation: spaces stand for them, so that all offsets hold and the
/// file stays valid (ISO 32000-1, 14.3.3: the entry is optional). Dates in compressed objects stay.
std::string pdf_without_date(std::string pdf);

/// A gnuplot expression for a string of exactly these characters; line breaks become spaces.
std::string gnuplot_string(const std::string& text);

}  // namespace porowave::reports
