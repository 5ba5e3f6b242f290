#include "reports/report/result_table.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reports/report/report_fixtures.hpp"
#include "reports/test_directory.hpp"

BOOST_AUTO_TEST_SUITE(result_table)

using namespace porowave::reports;
using porowave::tests::contains;

namespace {

ResultTable example() {
  return {"example", "50 % & more", {"name", "error"}, {{"a, b", "1.2e-05"}, {"c_d", "–"}}};
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(csv_has_empty_fields_for_missing_numbers) {
  BOOST_TEST(as_csv(example()) == "name,error\n\"a, b\",1.2e-05\nc_d,\n");
}

BOOST_AUTO_TEST_CASE(latex_is_a_table_with_booktabs) {
  const std::string text = as_latex(example());
  BOOST_TEST(contains(text, "\\begin{tabular}{lr}\n\\toprule\nname & error \\\\\n\\midrule\n"));
  BOOST_TEST(contains(text, "\na, b & 1.2e-05 \\\\\nc\\_d & -- \\\\\n\\bottomrule\n"));
  BOOST_TEST(contains(text, "\\caption{50 \\% \\& more}"));
  ResultTable tall = example();
  for (int i = 0; i < 60; ++i) tall.add({"x", "1"});
  BOOST_TEST(contains(as_latex(tall), "\\begin{longtable}{lr}"));
  BOOST_TEST(!contains(as_latex(tall), "tabular"));
}

BOOST_AUTO_TEST_CASE(markdown_names_what_it_leaves_out) {
  const std::string text = as_markdown(example(), 1);
  BOOST_TEST(contains(text, "| name | error |\n|---|--:|\n| a, b | 1.2e-05 |\n"));
  BOOST_TEST(contains(text, "1 more in `example.csv`"));
  BOOST_TEST(!contains(as_markdown(example(), 2), "more in"));
}

BOOST_AUTO_TEST_CASE(html_shows_texts_as_they_are) {
  ResultTable table = example();
  table.add({report_fixtures::nasty_name(), "1"});
  const std::string text = as_html(table, 10);
  BOOST_TEST(count_of(text, "<tr>") == 4u);
  BOOST_TEST(!contains(text, "<b>"));
  BOOST_TEST(!contains(text, "</script>"));
  BOOST_TEST(contains(text, "&lt;/script&gt;"));
  BOOST_TEST(count_of(as_html(table, 1), "<tr>") == 2u);
  BOOST_TEST(contains(as_html(table, 1), "1 of 3 rows"));
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_are_a_dash) {
  BOOST_TEST(error_text(NAN) == "–");
  BOOST_TEST(error_text(1.234e-5) == "1.23e-05");
  BOOST_TEST(number_text(HUGE_VAL) == "–");
  BOOST_TEST(number_text(0.25) == "0.25");
}

BOOST_AUTO_TEST_SUITE_END()
