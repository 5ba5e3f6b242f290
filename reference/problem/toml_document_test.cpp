#include "reference/problem/toml_document.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/errors.hpp"

BOOST_AUTO_TEST_SUITE(toml_document)

using porowave::InputError;
using porowave::Range;
using porowave::same_value;
using porowave::TomlDocument;

namespace {

/// The message of the InputError that `action` throws.
template <class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const TomlDocument sample = TomlDocument::parse(
    "[a]\nwhole = 3\nreal = 0.25\nword = \"mls\"\nlist = [1, 2.5]\nflag = true\n", "case.toml");

}  // namespace

BOOST_AUTO_TEST_CASE(values_of_the_right_type_are_read) {
  auto section = sample.section("a");
  BOOST_TEST(section.present());
  BOOST_TEST(section.integer("whole", 1, 5) == 3);
  BOOST_TEST(section.number("whole", Range::positive()) == 3.0);
  BOOST_TEST(section.number("real", Range::inside(0, 1)) == 0.25);
  BOOST_TEST(section.text("word") == "mls");
  const std::vector<double> expected = {1.0, 2.5};
  BOOST_TEST(section.numbers_or("list", {}, Range::positive()) == expected);
  BOOST_TEST(section.number_or("absent", 7.0, Range::positive()) == 7.0);
  BOOST_TEST(!section.has("absent"));
}

BOOST_AUTO_TEST_CASE(messages_name_file_line_key_value_and_expectation) {
  auto section = sample.section("a");
  BOOST_TEST(message_of([&] { section.number("real", Range::inside(1, 2)); }) ==
             "case.toml:3: [a] real = 0.25: expected a number > 1 and < 2");
  BOOST_TEST(message_of([&] { section.number("absent", Range::positive()); }) ==
             "case.toml: [a] absent is missing: expected a number > 0");
  BOOST_TEST(message_of([&] { section.integer("real", 1, 9); }) ==
             "case.toml:3: [a] real = 0.25: expected a whole number from 1 to 9");
  BOOST_TEST(message_of([&] { section.number("word", Range::positive()); }) ==
             "case.toml:4: [a] word = \"mls\": expected a number > 0");
  BOOST_TEST(message_of([&] { section.number("flag", Range::positive()); }) ==
             "case.toml:6: [a] flag = true: expected a number > 0");
  BOOST_TEST(message_of([&] { section.text("whole"); }) ==
             "case.toml:2: [a] whole = 3: expected a string");
  BOOST_TEST(
      message_of([&] { section.numbers_or("list", {}, Range::inside(0, 2)); }) ==
      "case.toml:5: [a] list = [ 1, 2.5 ]: expected a list, each entry a number > 0 and < 2");
}

BOOST_AUTO_TEST_CASE(a_word_is_one_of_those_known) {
  constexpr std::array<std::string_view, 2> words = {"shape", "mls"};
  auto section = sample.section("a");
  BOOST_TEST(section.choice("word", words) == 1u);
  constexpr std::array<std::string_view, 2> others = {"mlx", "apic"};
  BOOST_TEST(message_of([&] { section.choice("word", others); }) ==
             "case.toml:4: [a] word = \"mls\": expected one of mlx, apic (did you mean mlx?)");
}

BOOST_AUTO_TEST_CASE(keys_that_nobody_asked_for_are_refused_with_a_suggestion) {
  const auto document = TomlDocument::parse("[a]\nporosty = 0.4\n", "p.toml");
  auto section = document.section("a");
  section.has("porosity");
  section.has("length");
  BOOST_TEST(message_of([&] { section.done(); }) ==
             "p.toml:2: [a] porosty = 0.4: unknown key; did you mean porosity?");
}

BOOST_AUTO_TEST_CASE(tables_that_nobody_knows_are_refused) {
  const auto document = TomlDocument::parse("top = 1\n[materiel]\n", "p.toml");
  BOOST_TEST(message_of([&] {
               document.only({"material", "top"});
             }) == "p.toml:2: [materiel]: unknown table; did you mean material?");
  BOOST_TEST(message_of([&] { document.only({"materiel"}); }) ==
             "p.toml:1: top: unknown top-level key; expected one of materiel");
  BOOST_TEST(message_of([&] { document.section("top"); }) ==
             "p.toml:1: top = 1: expected a table [top]");
}

BOOST_AUTO_TEST_CASE(text_that_is_not_toml_is_refused_with_its_line) {
  for (const char* text : {"[a]\nb = = 1\n", "[a\n", "a = 1\na = 2\n", "`<", "\x01", "= 1"}) {
    const std::string message = message_of([&] { TomlDocument::parse(text, "x.toml"); });
    BOOST_TEST(message.rfind("x.toml:", 0) == 0u);
    BOOST_TEST(message.find("not TOML") != std::string::npos);
  }
  BOOST_TEST(message_of([] { TomlDocument::load("/nonexistent/x.toml"); }) ==
             "/nonexistent/x.toml: cannot be read: expected a TOML file");
  BOOST_TEST(message_of([] { TomlDocument::load("/"); }) ==
             "/: cannot be read: expected a TOML file");
}

BOOST_AUTO_TEST_CASE(not_a_number_and_infinity_are_never_in_range) {
  const auto document = TomlDocument::parse("[a]\nx = nan\ny = inf\n", "p.toml");
  auto section = document.section("a");
  BOOST_TEST(message_of([&] { section.number("x", Range{}); }) ==
             "p.toml:2: [a] x = nan: expected a number");
  BOOST_TEST(message_of([&] { section.number("y", Range{}); }) ==
             "p.toml:3: [a] y = inf: expected a number");
}

BOOST_AUTO_TEST_CASE(axes_hold_values_of_any_kind_in_the_order_of_the_file) {
  const auto document = TomlDocument::parse(
      "[axes]\nzeta = [\"a\", \"b\"]\nalpha = [1, 2.5]\nlists = [[], [0.1, 2]]\n"
      "seed = { first = 3, count = 2 }\n",
      "study.toml");
  auto axes = document.section("axes");
  BOOST_TEST(axes.keys() == (std::vector<std::string>{"zeta", "alpha", "lists", "seed"}),
             boost::test_tools::per_element());
  std::vector<std::string> texts;
  for (const auto& key : axes.keys()) {
    for (const auto& value : axes.values(key)) texts.push_back(value.text());
  }
  const std::vector<std::string> expected = {"\"a\"", "\"b\"",      "1", "2.5",
                                             "[]",    "[0.1, 2.0]", "3", "4"};
  BOOST_TEST(texts == expected, boost::test_tools::per_element());
  BOOST_TEST(axes.values("alpha")[0].line == 3);
}

BOOST_AUTO_TEST_CASE(wrong_axes_are_refused_with_their_line) {
  const auto document = TomlDocument::parse(
      "[axes]\na = []\nb = 3\nc = [[\"x\"]]\nd = { first = 1, count = 0 }\n"
      "e = { first = 1, count = 2, step = 2 }\n",
      "study.toml");
  auto axes = document.section("axes");
  for (const char* key : {"a", "b", "c", "d", "e"}) {
    BOOST_CHECK_EXCEPTION(axes.values(key), InputError, [&](const InputError& error) {
      const std::string line = std::to_string(axes.line_of(key));
      return std::string(error.what()).starts_with("study.toml:" + line + ": [axes] " + key);
    });
  }
}

BOOST_AUTO_TEST_CASE(a_range_is_of_whole_numbers_that_exist) {
  for (const std::string range :
       {"first = 1.1e38, count = 2", "first = 1, count = 1e300", "first = 1.0, count = 2",
        "first = true, count = 2", "first = nan, count = 2", "first = 1, count = inf",
        "first = 9223372036854775807, count = 2", "first = 1, count = 1000001"}) {
    const auto document = TomlDocument::parse("[axes]\na = { " + range + " }\n", "study.toml");
    BOOST_CHECK_EXCEPTION(document.section("axes").values("a"), InputError,
                          [&](const InputError& error) {
                            return std::string(error.what()).starts_with("study.toml:2: [axes] a");
                          });
  }
  const auto document =
      TomlDocument::parse("[axes]\na = { first = 9223372036854775805, count = 2 }\n", "study.toml");
  BOOST_TEST(document.section("axes").values("a").back().text() == "9223372036854775806");
}

BOOST_AUTO_TEST_CASE(integers_that_no_double_holds_are_rounded_in_lists) {
  const auto document =
      TomlDocument::parse("[axes]\na = [[100, 8088888888888888881, 0.5]]\n", "study.toml");
  const auto value = document.section("axes").values("a").at(0);
  const std::vector<double> expected = {100.0, 8088888888888888881.0, 0.5};
  BOOST_TEST(std::get<std::vector<double>>(value.value) == expected,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_value_put_in_is_read_and_messages_name_its_own_line) {
  const auto base = TomlDocument::parse("[a]\nx = 1\ny = 2\n", "study.toml");
  const auto changed = base.with("a", "x", {5.5, 12}).with("b", "z", {std::string("q"), 13});
  BOOST_TEST(base.section("a").number("x", {}) == 1.0);
  BOOST_TEST(changed.section("a").number("x", {}) == 5.5);
  BOOST_TEST(changed.section("b").text("z") == "q");
  const auto line_of = [&](const char* section, const char* key) {
    try {
      changed.section(section).refuse(key, "something else");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  BOOST_TEST(line_of("a", "x") == "study.toml:12: [a] x = 5.5: expected something else");
  BOOST_TEST(line_of("a", "y") == "study.toml:3: [a] y = 2: expected something else");
  BOOST_TEST(line_of("b", "z") == "study.toml:13: [b] z = \"q\": expected something else");
}

BOOST_AUTO_TEST_CASE(canonical_text_depends_on_content_alone_and_reads_back) {
  const auto one = TomlDocument::parse("[b]\ny = \"w\\\"\\\\\"\nx = 0.1\n[a]\nz=[1,2]\n", "one");
  const auto other =
      TomlDocument::parse("# note\n[a]\nz = [1.0, 2.0]\n[b]\nx=1e-1\ny='w\"\\'\n[c]\n", "other");
  const std::string text = one.canonical({"a", "b"});
  BOOST_TEST(text == other.canonical({"a", "b"}));
  BOOST_TEST(TomlDocument::parse(text, "again").canonical({"a", "b"}) == text);
  BOOST_TEST(text != one.with("b", "x", {0.1 + 1e-17 + 2e-17, 1}).canonical({"a", "b"}));
}

BOOST_AUTO_TEST_CASE(a_table_left_out_is_gone_and_the_lines_of_others_stay) {
  const auto document = TomlDocument::parse("[a]\nx = 1\n[b]\ny = 2\n", "p.toml").without({"a"});
  BOOST_TEST(!document.section("a").present());
  BOOST_TEST(message_of([&] { document.section("b").refuse("y", "another"); }) ==
             "p.toml:4: [b] y = 2: expected another");
}

BOOST_AUTO_TEST_CASE(arrays_of_tables_are_sections) {
  const auto document =
      TomlDocument::parse("[[exclude]]\nk = 1\n[[exclude]]\nk = 2\nm = 3\n", "study.toml");
  auto found = document.sections("exclude");
  BOOST_REQUIRE(found.size() == 2U);
  BOOST_TEST(found[1].value_if("k")->text() == "2");
  BOOST_CHECK_EXCEPTION(found[1].done(), InputError, [](const InputError& error) {
    return std::string(error.what()).starts_with("study.toml:5: [exclude] m = 3: unknown key");
  });
  BOOST_TEST(document.sections("other").empty());
  const auto wrong = TomlDocument::parse("exclude = 3\n", "study.toml");
  BOOST_CHECK_THROW(wrong.sections("exclude"), InputError);
}

BOOST_AUTO_TEST_CASE(whole_and_decimal_numbers_are_the_same_value) {
  BOOST_TEST(same_value({std::int64_t{5}, 1}, {5.0, 2}));
  BOOST_TEST(!same_value({std::int64_t{5}, 1}, {5.5, 1}));
  BOOST_TEST(!same_value({std::string("5"), 1}, {5.0, 1}));
  BOOST_TEST(same_value({true, 1}, {true, 9}));
}

BOOST_AUTO_TEST_SUITE_END()
