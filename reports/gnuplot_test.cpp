#include "reports/gnuplot.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "reference/problem/errors.hpp"
#include "reports/process.hpp"
#include "reports/test_directory.hpp"
#include "reports/test_pictures.hpp"

BOOST_AUTO_TEST_SUITE(gnuplot)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;
namespace fs = std::filesystem;

namespace {

/// One curve of two levels.
Figure small_figure(const std::string& caption = "caption", const std::string& title = "title") {
  return {"figure",
          "convergence",
          {{"caption", caption},
           {"curves", "1"},
           {"curve1", title},
           {"triangle_h", "0.001"},
           {"triangle_error", "0.001"}},
          "# data\n100 1e-3 1e-2 1e-3\n200 5e-4 2.5e-3 4e-3\n\n\n"};
}

/// A directory with nothing but a program `gnuplot` of this text.
void make_gnuplot(const TestDirectory& folder, const std::string& script) {
  write_text(folder / "gnuplot", "#!/bin/sh\n" + script + "\n");
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
}

std::string drawing_error(const Figure& figure, const TestDirectory& folder) {
  return message_of<EnvironmentError>([&] { draw(figure, folder.path()); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(gnuplot_reads_strings_as_they_are) {
  const TestDirectory folder;
  for (const std::string text :
       {"plain", "", "it's", "''", "'", "'a'", "a''''b", "\"double\"", "back\\slash\\n",
        "ends in \\", "@macro", "{}", "{/Bold x}_1^2", "100 % %s %d", "$(date)", "`date`",
        "# no comment", "a; b", "σ′ – µ"}) {
    write_text(folder / "s.gp", "set print '-'\nprint " + gnuplot_string(text) + "\n");
    const ProcessResult result = run_process({"gnuplot", "s.gp"}, folder.path());
    BOOST_TEST(result.output == text + "\n");
    BOOST_TEST(result.errors == "");
  }
  BOOST_TEST(gnuplot_string("two\nlines\r") == "'two lines '");
}

BOOST_AUTO_TEST_CASE(a_figure_is_four_files_that_are_the_same_every_time) {
  const TestDirectory first;
  const TestDirectory second;
  const auto files = draw(small_figure(), first.path());
  BOOST_TEST(first.contents() == "figure.dat figure.gp figure.png figure.svg");
  BOOST_REQUIRE(files.size() == 4u);
  for (const auto& file : files) BOOST_TEST(fs::exists(file));
  check_pictures(first.path(), "figure");
  draw(small_figure(), second.path());
  for (const auto& file : files) {
    BOOST_TEST(text_of(file) == text_of(second / file.filename()), file << " differs");
  }
}

BOOST_AUTO_TEST_CASE(anyone_can_draw_it_again) {
  const TestDirectory folder;
  draw(small_figure(), folder.path());
  const std::string svg = text_of(folder / "figure.svg");
  fs::remove(folder / "figure.svg");
  BOOST_TEST(run_process({"gnuplot", "figure.gp"}, folder.path()).exit_code == 0);
  BOOST_TEST(text_of(folder / "figure.svg") == svg);
}

BOOST_AUTO_TEST_CASE(texts_are_shown_and_never_run) {
  for (const std::string text :
       {"'; system(\"touch pwned\"); '", "\"; system('touch pwned'); \"", "`touch pwned`",
        "$(touch pwned)", "'\nsystem('touch pwned')\n'", "\\'; system('touch pwned') #",
        "'.system('touch pwned').'", "@pwned", "\\", "%s%n", "{/Bold"}) {
    BOOST_TEST_CONTEXT(text) {
      const TestDirectory folder;
      draw(small_figure(text, text), folder.path());
      BOOST_TEST(folder.contents() == "figure.dat figure.gp figure.png figure.svg");
    }
  }
  const TestDirectory folder;
  draw(small_figure("h_0 ^{2} {/Bold b} 5 % `c` \\d @e", "f_1 it's"), folder.path());
  const std::string svg = text_of(folder / "figure.svg");
  BOOST_TEST(contains(svg, "h_0 ^{2} {/Bold b} 5 % `c` \\d @e"));
  BOOST_TEST(contains(svg, "f_1 it's"));
}

BOOST_AUTO_TEST_CASE(names_that_lead_elsewhere_are_refused) {
  const TestDirectory folder;
  for (const std::string name : {"", "../figure", "a/b", "a b", "a'b", "a.b", "$a", "-\n", "ä"}) {
    Figure figure = small_figure();
    figure.name = name;
    BOOST_CHECK_THROW(draw(figure, folder.path()), std::invalid_argument);
  }
  Figure figure = small_figure();
  figure.template_name = "no_such_template";
  BOOST_CHECK_THROW(draw(figure, folder.path()), std::invalid_argument);
  BOOST_TEST(folder.contents() == "");
}

BOOST_AUTO_TEST_CASE(a_figure_that_cannot_be_drawn_leaves_nothing) {
  const TestDirectory folder;
  Figure without_count = small_figure();
  without_count.texts.erase(without_count.texts.begin() + 1);
  BOOST_TEST(contains(drawing_error(without_count, folder), "on figure figure: "));
  BOOST_TEST(contains(drawing_error(without_count, folder), "undefined variable: curves"));
  BOOST_TEST(folder.contents() == "");
  Figure without_data = small_figure();
  without_data.data = "# nothing\n";
  BOOST_TEST(contains(drawing_error(without_data, folder), "gnuplot failed (exit code 1)"));
  BOOST_TEST(folder.contents() == "");
  write_text(folder / "file", "");
  BOOST_CHECK_THROW(draw(small_figure(), folder / "file"), EnvironmentError);
  BOOST_TEST(folder.contents() == "file");
}

BOOST_AUTO_TEST_CASE(without_gnuplot_the_remedy_is_named) {
  const TestDirectory empty;
  const TestDirectory folder;
  BOOST_CHECK_NO_THROW(require_gnuplot());
  const TestVariable path("PATH", empty.path().string());
  const auto message = message_of<EnvironmentError>(require_gnuplot);
  BOOST_TEST(contains(message, "gnuplot: cannot be started"));
  BOOST_TEST(contains(message, "apt-get install gnuplot-nox"));
  BOOST_TEST(contains(drawing_error(small_figure(), folder), "gnuplot: cannot be started"));
  BOOST_TEST(folder.contents() == "");
}

BOOST_AUTO_TEST_CASE(a_gnuplot_that_fails_is_noticed) {
  const TestDirectory programs;
  const TestDirectory folder;
  const TestVariable path("PATH", programs.path().string());
  make_gnuplot(programs, "echo broken >&2; exit 3");
  BOOST_TEST(contains(message_of<EnvironmentError>(require_gnuplot), "apt-get install"));
  BOOST_TEST(contains(drawing_error(small_figure(), folder), "(exit code 3)"));
  BOOST_TEST(contains(drawing_error(small_figure(), folder), "broken"));
  BOOST_TEST(folder.contents() == "");
  make_gnuplot(programs, "echo > figure.svg; echo > figure.png; exit 1");  // half a picture
  BOOST_TEST(contains(drawing_error(small_figure(), folder), "(exit code 1)"));
  BOOST_TEST(folder.contents() == "");
  make_gnuplot(programs, "echo > figure.svg");  // no picture, no error
  BOOST_TEST(contains(drawing_error(small_figure(), folder), "(exit code 0)"));
  BOOST_TEST(folder.contents() == "");
}

// The table of offsets at the end of a PDF counts bytes, so none may move.
BOOST_AUTO_TEST_CASE(dates_of_a_pdf_become_spaces) {
  const std::string before = "12 0 obj\n<< /Producer (cairo)\n   ";
  const std::string after = "\n>>\nendobj\nxref";
  const std::string date = "/CreationDate (D:20261122181953+01'00)";
  BOOST_TEST(pdf_without_date(before + date + after) ==
             before + std::string(date.size(), ' ') + after);
  BOOST_TEST(pdf_without_date(before + after) == before + after);
  BOOST_TEST(pdf_without_date("/CreationDate (D:2026") == "/CreationDate (D:2026");
  BOOST_TEST(pdf_without_date("") == "");
}

BOOST_AUTO_TEST_SUITE_END()
