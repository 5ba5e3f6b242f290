#include "reports/report/text_forms.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "reports/process.hpp"
#include "reports/test_directory.hpp"

BOOST_AUTO_TEST_SUITE(text_forms)

using namespace porowave::reports;
using namespace porowave::tests;

namespace {

const std::string nasty = R"(<b>"a" & 'b'</script>\n{x_1^2}~%#$|`)";

}  // namespace

BOOST_AUTO_TEST_CASE(html_leaves_no_mark_up) {
  BOOST_TEST(html_text("a<b>&\"'\n") == "a&lt;b&gt;&amp;&quot;&#39; ");
  BOOST_TEST(html_text(nasty).find_first_of("<>\"'") == std::string::npos);
  BOOST_TEST(html_text("σ′ ≤ ü") == "σ′ ≤ ü");
}

BOOST_AUTO_TEST_CASE(json_in_html_is_the_same_json_and_cannot_end_its_element) {
  const nlohmann::json value = {{"name", nasty}, {"list", {1, 2}}};
  const std::string text = json_in_html(value.dump());
  BOOST_TEST(text.find('<') == std::string::npos);
  BOOST_TEST((nlohmann::json::parse(text) == value));
}

BOOST_AUTO_TEST_CASE(csv_quotes_only_what_it_must) {
  BOOST_TEST(csv_field("plain word") == "plain word");
  BOOST_TEST(csv_field("a,b") == "\"a,b\"");
  BOOST_TEST(csv_field("say \"x\"") == "\"say \"\"x\"\"\"");
  BOOST_TEST(csv_field("two\nlines") == "\"two\nlines\"");
}

BOOST_AUTO_TEST_CASE(latex_has_no_active_character_left) {
  BOOST_TEST(latex_text("50 % of x_1 & {y}#$") == "50 \\% of x\\_1 \\& \\{y\\}\\#\\$");
  BOOST_TEST(latex_text("a\\b~^") == "a\\textbackslash{}b\\textasciitilde{}\\textasciicircum{}");
}

BOOST_AUTO_TEST_CASE(markdown_stays_in_its_cell) {
  BOOST_TEST(markdown_text("a|b\n<i>_x_") == "a\\|b &lt;i&gt;\\_x\\_");
}

BOOST_AUTO_TEST_CASE(a_shell_gives_the_word_back) {
  BOOST_TEST(shell_word("results/a.b") == "results/a.b");
  for (const std::string& word :
       {nasty, std::string("two words"), std::string("it's"), std::string()}) {
    const auto result = run_process({"sh", "-c", "printf %s " + shell_word(word)}, ".");
    BOOST_TEST(result.output == word);
  }
}

BOOST_AUTO_TEST_CASE(shortened_counts_characters_not_bytes) {
  BOOST_TEST(shortened("abc", 3) == "abc");
  BOOST_TEST(shortened("abcd", 3) == "ab…");
  BOOST_TEST(shortened("üüüü", 3) == "üü…");
  BOOST_TEST(shortened("üüü", 3) == "üüü");
}

BOOST_AUTO_TEST_CASE(base64_of_rfc_4648) {
  BOOST_TEST(base64("") == "");
  BOOST_TEST(base64("f") == "Zg==");
  BOOST_TEST(base64("fo") == "Zm8=");
  BOOST_TEST(base64("foo") == "Zm9v");
  BOOST_TEST(base64("foobar") == "Zm9vYmFy");
  BOOST_TEST(base64(std::string("\xff\x00", 2)) == "/wA=");
}

BOOST_AUTO_TEST_SUITE_END()
