#include "reports/report/page.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "reports/output_file.hpp"
#include "reports/plot_templates.hpp"
#include "reports/report/report.hpp"
#include "reports/report/report_fixtures.hpp"
#include "reports/report/summary.hpp"
#include "reports/test_directory.hpp"
#include "verification/store/store.hpp"

BOOST_AUTO_TEST_SUITE(page)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::reports::report_fixtures;
using namespace porowave::tests;
using verification::Record;

namespace {

struct Made {
  explicit Made(const std::vector<Record>& rows) {
    const std::string path = (folder / "store").string();
    verification::Store::create_or_open(path).add(rows);
    options.store = path;
  }
  ReportContent content() const { return read_report(options); }
  std::string page() const { return page_html(content(), folder.path()); }

  TestDirectory folder;
  ReportOptions options;
};

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const auto at = text.find(begin);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, begin);
  const auto from = at + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

nlohmann::json data_of(const std::string& page) {
  return nlohmann::json::parse(between(page, "id=\"data\">", "</script>"));
}

/// The specification of a case as the page's script puts it together.
std::string specification(const nlohmann::json& group, const nlohmann::json& one) {
  if (one[7].is_string()) return one[7];
  std::vector<std::string> lines(1);
  for (const char c : group["spec"].get<std::string>()) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  for (const auto& difference : one[7]) lines[difference[0]] = difference[1];
  std::string text = lines[0];
  for (std::size_t i = 1; i < lines.size(); ++i) text += "\n" + lines[i];
  return text;
}

/// Relative luminance and contrast of WCAG 2.
double luminance(const std::string& colour) {
  const std::array<double, 3> weight = {0.2126, 0.7152, 0.0722};
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum += weight[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}
double contrast(const std::string& a, const std::string& b) {
  const double x = luminance(a);
  const double y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_case_leads_to_its_row_specification_and_command) {
  auto rows = full_study();
  rows[0] = broken(rows[0]);
  rows[1].specification += "courant = 0.25\n";  // one line more than the others of its group
  const Made made(rows);
  const auto data = data_of(made.page());
  std::map<std::string, const Record*> by_id;
  for (const Record& row : rows) by_id[row.id] = &row;
  std::set<std::string> seen;
  for (const auto& group : data["studies"][0]["groups"]) {
    for (const auto& one : group["cases"]) {
      const Record& row = *by_id.at(one[0]);
      seen.insert(row.id);
      BOOST_TEST(specification(group, one) == row.specification);
      BOOST_TEST(one[3].get<int>() == static_cast<int>(row.status));
      BOOST_TEST(one[8].get<std::string>() == row.reason);
    }
  }
  BOOST_TEST(seen.size() == rows.size());
  BOOST_TEST(data["rerun"].get<std::string>() ==
             "porowave sweep STUDY.toml --store " + made.options.store + " --case ");
}

BOOST_AUTO_TEST_CASE(nasty_names_survive) {
  const std::string nasty = nasty_name();
  const Made made(full_study(nasty));
  const std::string text = made.page();
  const auto data = data_of(text);
  BOOST_TEST(data["studies"][0]["name"].get<std::string>() == nasty);
  BOOST_TEST(!contains(text, "<b>"));
  // Two scripts begin and two end: no name has ended one.
  const auto count = [&](const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
  };
  BOOST_TEST(count("<script") == 2u);
  BOOST_TEST(count("</script>") == 2u);
  BOOST_TEST(contains(text, "&lt;/script&gt;"));
}

BOOST_AUTO_TEST_CASE(no_address_and_a_text_for_every_picture) {
  const Made made(full_study());
  ReportOptions options = made.options;
  options.output = (made.folder / "report").string();
  write_report(options);
  const std::string text = text_of(made.folder / "report/index.html");
  BOOST_TEST(!contains(text, "http:"));
  BOOST_TEST(!contains(text, "https:"));
  BOOST_TEST(!contains(text, "src=\"//"));
  const std::regex image("<img ([^>]*)>");
  std::size_t images = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), image), end; i != end; ++i, ++images) {
    const std::string attributes = (*i)[1].str().substr(0, 300);
    BOOST_TEST(std::regex_search(attributes, std::regex("alt=\"[^\"]{20,}")), attributes);
  }
  BOOST_TEST(images == made.content().studies[0].figures.size());
  // Every file that the page leads to is there.
  const std::regex link("href=\"([a-z0-9_.]+)\"");
  std::size_t links = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i, ++links) {
    BOOST_TEST(std::filesystem::exists(made.folder / "report" / (*i)[1].str()), (*i)[1].str());
  }
  BOOST_TEST(links > 5 * images);
}

BOOST_AUTO_TEST_CASE(colours_have_the_contrast_of_wcag_aa) {
  const std::string css = plot_template("page.css");
  const std::regex root(":root \\{([^}]*)\\}");
  int themes = 0;
  for (std::sregex_iterator i(css.begin(), css.end(), root), end; i != end; ++i, ++themes) {
    std::map<std::string, std::string> colour;
    const std::string rules = (*i)[1].str();
    const std::regex variable("--([a-z]+): (#[0-9a-f]{6})");
    for (std::sregex_iterator v(rules.begin(), rules.end(), variable); v != end; ++v) {
      colour[(*v)[1]] = (*v)[2];
    }
    for (const char* text : {"ink", "quiet", "link", "good", "bad", "unsure"}) {
      if (!colour.contains(text)) continue;
      for (const char* ground : {"paper", "soft"}) {
        const double ratio = contrast(colour.at(text), colour.at(ground));
        BOOST_TEST(ratio >= 4.5,
                   text << " on " << ground << " in theme " << themes << ": " << ratio);
      }
    }
    // Borders of controls.
    if (colour.contains("line")) BOOST_TEST(contrast(colour.at("line"), colour.at("paper")) >= 3.0);
  }
  BOOST_TEST(themes == 3);  // light, dark, print
}

BOOST_AUTO_TEST_CASE(a_store_of_many_groups_has_few_rows_in_its_page) {
  std::vector<Record> rows;
  for (int i = 0; i < 3000; ++i) rows.push_back(row({"bspline1", 1.0 + 0.001 * i}, 0.1));
  const std::string text = Made(rows).page();
  std::size_t count = 0;
  for (auto at = text.find("<tr>"); at != std::string::npos; at = text.find("<tr>", at + 1))
    ++count;
  BOOST_TEST(count < 300u);
  BOOST_TEST(data_of(text)["studies"][0]["groups"].size() == 3000u);
}

BOOST_AUTO_TEST_CASE(an_empty_store_says_how_to_fill_it) {
  const Made made({});
  const std::string text = made.page();
  BOOST_TEST(contains(text, "the store holds no cases"));
  BOOST_TEST(contains(text, "porowave sweep STUDY.toml --store"));
  BOOST_TEST(data_of(text)["studies"].empty());
  BOOST_TEST(contains(summary_markdown(made.content()), "the store holds no cases"));
}

BOOST_AUTO_TEST_CASE(a_store_of_another_build_is_told_from_missing_cases) {
  ReportContent content;
  verification::Provenance other = verification::current_provenance();
  other.numerics = "other";
  content.provenance = {other};
  BOOST_TEST(build_note(content) == "");  // nothing is judged
  content.verdicts.emplace();
  BOOST_TEST(contains(build_note(content), "other numerics"));
  content.provenance.push_back(verification::current_provenance());
  BOOST_TEST(build_note(content) == "");
}

BOOST_AUTO_TEST_CASE(the_summary_counts_what_there_is) {
  auto rows = full_study();
  rows[0] = broken(rows[0]);
  const Made made(rows);
  const std::string text = summary_markdown(made.content());
  BOOST_TEST(contains(text, "of 4 groups 3 have an observed order, 1 with errors missing"), text);
  BOOST_TEST(contains(text, "- trial: 48 cases, 47 done, 1 broke down; 4 groups\n"), text);
  BOOST_TEST(contains(text, "step 7: &lt;it&gt; broke \"down\""), text);
}

BOOST_AUTO_TEST_SUITE_END()
