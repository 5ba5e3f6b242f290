#include "reference/problem/csv_reader.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/errors.hpp"

BOOST_AUTO_TEST_SUITE(csv_reader)

using namespace porowave;

namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(const std::string& text) {
  CsvReader reader = CsvReader::of_text(text, "p.csv");
  Rows rows = {reader.columns()};
  while (reader.next()) {
    rows.emplace_back();
    for (std::size_t i = 0; i < reader.columns().size(); ++i) {
      rows.back().push_back(reader.cell(i));
    }
  }
  return rows;
}

template <class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// What reading the text as numbers >= 0 says.
std::string refusal(const std::string& text) {
  return message_of([&] {
    CsvReader reader = CsvReader::of_text(text, "p.csv");
    while (reader.next()) {
      for (std::size_t i = 0; i < reader.columns().size(); ++i) {
        reader.number(i, Range::between(0.0, 1e300));
      }
    }
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_same_table_however_it_was_written) {
  const Rows plain = rows_of("x,name\n1,a\n2,b\n");
  BOOST_TEST((plain == Rows{{"x", "name"}, {"1", "a"}, {"2", "b"}}));
  for (const std::string text :
       {"x,name\r\n1,a\r\n2,b\r\n", "x,name\n1,a\n2,b", "\xef\xbb\xbfx,name\n1,a\n2,b\n",
        "\n# made by hand\nx,name\n\n1,a\n  # more\n \t\n2,b\n\n", " x , name\n1 ,\ta\n  2,b \n",
        "\"x\",\"name\"\n\"1\",a\n 2 , \"b\" \r\n"}) {
    BOOST_TEST_CONTEXT(text) BOOST_TEST((rows_of(text) == plain));
  }
}

BOOST_AUTO_TEST_CASE(quotes_keep_commas_quotes_spaces_and_marks) {
  BOOST_TEST((rows_of("a,b,c\n\"1,5\",\"a \"\"b\"\"\",\" # \"\n") ==
              Rows{{"a", "b", "c"}, {"1,5", "a \"b\"", " # "}}));
  BOOST_TEST((rows_of("a,b,c\n\"\",,\"\"\n") == Rows{{"a", "b", "c"}, {"", "", ""}}));
}

BOOST_AUTO_TEST_CASE(numbers_of_every_notation) {
  CsvReader reader = CsvReader::of_text("x\n+1.5e-3\n-2\n.5\n1E2\n4.9e-324\n", "p.csv");
  for (const double expected : {1.5e-3, -2.0, 0.5, 100.0, 4.9e-324}) {
    BOOST_TEST_REQUIRE(reader.next());
    BOOST_TEST(reader.number(0) == expected);
  }
  BOOST_TEST(!reader.next());
}

BOOST_AUTO_TEST_CASE(values_that_are_no_numbers_are_named_with_their_line) {
  const std::string expected = ": expected a number >= 0 and <= 1e+300";
  for (const std::string word : {"nan", "NaN", "-nan", "inf", "-inf", "one", "1.0x", "1 2", "-1",
                                 "0x10", "+-1", "++1", "1e999", "1D-5", "--1"}) {
    BOOST_TEST(refusal("t,x\n1,2\n# comment\n\n3," + word + "\n") ==
               "p.csv:5: x " + word + expected);
  }
  BOOST_TEST(refusal("t,x\n1,\n") == "p.csv:2: x (empty)" + expected);
  BOOST_TEST(refusal("t,x\n1,a\x01\x1b[31m\n") == "p.csv:2: x a??[31m" + expected);
  BOOST_TEST(refusal("t,x\n1," + std::string(5000, '7') + "\n").size() < 200U);
}

BOOST_AUTO_TEST_CASE(rows_of_another_length_are_refused) {
  BOOST_TEST(refusal("t,x\n1,2\n3\n") ==
             "p.csv:3: 1 values: expected 2, as many as there are columns in line 1");
  BOOST_TEST(refusal("\nt,x\n1,2,3\n") ==
             "p.csv:3: 3 values: expected 2, as many as there are columns in line 2");
  BOOST_TEST(refusal("t,x\n1,2,\n").find("p.csv:2: 3 values") == 0U);
}

BOOST_AUTO_TEST_CASE(what_is_no_table_is_refused_at_its_line) {
  const auto begins = [](const std::string& text, const std::string& expected) {
    const std::string message = message_of([&] { rows_of(text); });
    BOOST_TEST(message.find(expected) == 0U, message);
  };
  begins("", "p.csv: no header: expected a first row");
  begins("\n# only\n \n", "p.csv: no header: expected a first row");
  begins("1,2\n3,4\n", "p.csv:1: 1,2: expected the names of the columns");
  begins("# x,t\n1.5,2\n", "p.csv:2: 1.5,2: expected the names of the columns");
  begins("x;t\n1;2\n", "p.csv:1: x;t: expected commas between the columns");
  begins("x,t\n1,\"2\n", "p.csv:2: \"2: expected a quote that is closed");
  begins("x,t\n\"1\"2,3\n", "p.csv:2: \"1\"2,3: expected a quote that is closed");
  begins("\xff\xfex,t\n", "p.csv:1: UTF-16: expected text in UTF-8");
  begins("x\n1\n" + std::string(1'000'001, '1'), "p.csv:3: more than 1000000 characters: expected");
}

BOOST_AUTO_TEST_CASE(columns_are_found_by_name) {
  const CsvReader reader = CsvReader::of_text("\n t ,x,\"a,b\",x\n", "p.csv");
  BOOST_TEST((reader.find("t") == 0U));
  BOOST_TEST((reader.find("a,b") == 2U));
  BOOST_TEST(!reader.find("T"));
  BOOST_TEST(reader.require("t", "a time") == 0U);
  BOOST_TEST(message_of([&] { reader.require("y", "a column y"); }) ==
             "p.csv:2: y is missing: expected a column y");
  BOOST_TEST(message_of([&] { reader.find("x"); }) ==
             "p.csv:2: x appears twice: expected one column of that name");
}

BOOST_AUTO_TEST_CASE(files_that_cannot_be_read) {
  for (const std::string path : {"no/such/file.csv", "."}) {
    BOOST_TEST(message_of([&] { CsvReader::open(path); }) ==
               path + ": cannot be read: expected a CSV file");
  }
}

BOOST_AUTO_TEST_SUITE_END()
