#include "reports/junit.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(junit)

using porowave::reports::junit_of;
using porowave::verification::Verdict;
using porowave::verification::VerdictKind;

BOOST_AUTO_TEST_CASE(every_verdict_is_counted_as_what_it_is) {
  const std::vector<Verdict> verdicts = {
      {"a", "m", VerdictKind::pass, "order 2.00"},
      {"b", "m", VerdictKind::fail, "order 1.5"},
      {"c", "m", VerdictKind::xpass, "it works"},
      {"d", "m", VerdictKind::xfail, "known"},
      {"e", "m", VerdictKind::inconclusive, "one level"},
  };
  const std::string text = junit_of("trial", verdicts);
  BOOST_TEST_MESSAGE(text);
  for (const char* part :
       {"<testsuite name=\"trial\" tests=\"5\" failures=\"2\" errors=\"1\" skipped=\"1\">",
        "name=\"m\"><system-out>order 2.00</system-out></testcase>",
        "classname=\"b\" name=\"m\"><failure type=\"fail\" message=\"order 1.5\"/></testcase>",
        "<failure type=\"xpass\" message=\"it works\"/>", "<skipped message=\"xfail: known\"/>",
        "<error type=\"inconclusive\" message=\"one level\"/>"}) {
    BOOST_TEST(text.find(part) != std::string::npos, part);
  }
}

BOOST_AUTO_TEST_CASE(what_xml_cannot_hold_is_escaped_or_a_blank) {
  const std::string text =
      junit_of("<&>", {{"\"g\"", "a\nb\x01", VerdictKind::fail, "1 < 2 & \"3\""}});
  BOOST_TEST(text.find("<testsuite name=\"&lt;&amp;&gt;\"") != std::string::npos);
  BOOST_TEST(text.find("classname=\"&quot;g&quot;\" name=\"a b \"") != std::string::npos);
  BOOST_TEST(text.find("message=\"1 &lt; 2 &amp; &quot;3&quot;\"") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
