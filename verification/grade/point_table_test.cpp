#include "verification/grade/point_table.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/errors.hpp"

BOOST_AUTO_TEST_SUITE(point_table)

using namespace porowave;
using namespace porowave::verification;

namespace {

PointTable read(const std::string& text, const PointReading& reading = {.length = 0.1}) {
  CsvReader reader = CsvReader::of_text(text, "p.csv");
  return read_points(reader, reading);
}

void check_refused(const std::string& text, const std::string& expected,
                   const PointReading& reading = {.length = 0.1}) {
  std::string message;
  try {
    read(text, reading);
  } catch (const InputError& error) {
    message = error.what();
  }
  BOOST_TEST(message.find(expected) == 0U, "<" << message << "> is not <" << expected << ">");
  BOOST_TEST(message.find(": expected ") != std::string::npos, message);
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_are_found_wherever_their_column_stands) {
  const PointTable table = read(
      "note,fluid_velocity,t,volume,x,effective_stress\n"
      "a,-1,1e-5,2,0.01,-0.5\nb,-2,1e-5,3,0.02,-0.25\n");
  BOOST_TEST_REQUIRE(table.profiles.size() == 1U);
  const PointProfile& points = table.profiles[0];
  BOOST_TEST(points.time == 1e-5);
  BOOST_TEST((points.x == std::vector{0.01, 0.02}));
  BOOST_TEST((points.weight == std::vector{2.0, 3.0}));
  BOOST_TEST((points.fields[0] == std::vector{-0.5, -0.25}));
  BOOST_TEST(points.fields[1].empty());
  BOOST_TEST(points.fields[2].empty());
  BOOST_TEST((points.fields[3] == std::vector{-1.0, -2.0}));
  BOOST_TEST(table.has_volume);
  BOOST_TEST((table.ignored == std::vector<std::string>{"note"}));
}

BOOST_AUTO_TEST_CASE(a_weight_may_have_either_name_or_be_missing) {
  BOOST_TEST((read("x,t,weight,pore_pressure\n0,1,4,0\n").profiles[0].weight == std::vector{4.0}));
  const PointTable equal = read("x,t,pore_pressure\n0,1,0\n0,1,0\n");
  BOOST_TEST((equal.profiles[0].weight == std::vector{1.0, 1.0}));
  BOOST_TEST(!equal.has_volume);
  check_refused("x,t,volume,weight,pore_pressure\n0,1,1,1,0\n", "p.csv:1: volume and weight");
}

BOOST_AUTO_TEST_CASE(rows_of_different_times_are_kept_apart) {
  const PointTable table = read("x,t,pore_pressure\n0,2,1\n0,1,2\n0.1,2,3\n0,0,0\n");
  BOOST_TEST_REQUIRE(table.profiles.size() == 3U);
  BOOST_TEST(table.profiles[0].time == 0.0);
  BOOST_TEST(table.profiles[1].time == 1.0);
  BOOST_TEST((table.profiles[2].fields[1] == std::vector{1.0, 3.0}));
  BOOST_TEST((table.profiles[2].x == std::vector{0.0, 0.1}));
  std::string many = "x,t,pore_pressure\n";
  for (int i = 0; i <= 1000; ++i) many += "0," + std::to_string(i) + ",0\n";
  check_refused(many, "p.csv:1002: t 1000: expected at most 1000 different times");
}

BOOST_AUTO_TEST_CASE(a_time_is_given_once) {
  BOOST_TEST(read("x,pore_pressure\n0,1\n", {.time = 3.0}).profiles[0].time == 3.0);
  check_refused("x,pore_pressure\n0,1\n", "p.csv:1: t is missing: expected a column t, or --time");
  check_refused("x,t,pore_pressure\n0,1,1\n", "p.csv:1: a column t and a given time",
                {.time = 3.0});
}

BOOST_AUTO_TEST_CASE(columns_of_other_names) {
  const std::string text = "pos,time,p,pore_pressure\n0.05,1,7,8\n";
  const PointReading reading{{{"x", "pos"}, {"t", "time"}, {"pore_pressure", "p"}}, {}, 0.1};
  const PointTable table = read(text, reading);
  BOOST_TEST((table.profiles[0].x == std::vector{0.05}));
  BOOST_TEST((table.profiles[0].fields[1] == std::vector{7.0}));
  BOOST_TEST((table.ignored == std::vector<std::string>{"pore_pressure"}));
  check_refused(text, "p.csv:1: q is missing: expected a column of that name for pore_pressure",
                {{{"pore_pressure", "q"}}, {}, 0.1});
}

BOOST_AUTO_TEST_CASE(a_row_of_a_phase_has_the_fields_of_its_phase) {
  const std::string header = "phase,x,volume,velocity,effective_stress,pore_pressure\n";
  const PointTable table =
      read(header + "solid,0.01,2,5,-1,\nfluid,0.02,3,6,,4\n", {.time = 1.0, .length = 0.1});
  const PointProfile& points = table.profiles[0];
  BOOST_TEST((points.x == std::vector{0.01, 0.02}));
  for (std::size_t f = 0; f < 4; ++f) {
    const bool solid = f == 0 || f == 2;
    BOOST_TEST(std::isnan(points.fields[f][solid ? 1 : 0]));
    BOOST_TEST(!std::isnan(points.fields[f][solid ? 0 : 1]));
  }
  BOOST_TEST(points.fields[0][0] == -1.0);
  BOOST_TEST(points.fields[1][1] == 4.0);
  BOOST_TEST(points.fields[2][0] == 5.0);
  BOOST_TEST(points.fields[3][1] == 6.0);
  const auto refused = [&](const std::string& row, const std::string& expected) {
    check_refused(header + row, expected, {.time = 1.0, .length = 0.1});
  };
  refused("solid,0.01,2,5,-1,3\n",
          "p.csv:2: pore_pressure 3: expected nothing in a row of the solid");
  refused("fluid,0.01,2,5,-1,3\n",
          "p.csv:2: effective_stress -1: expected nothing in a row of the");
  refused("solid,0.01,2,5,,\n", "p.csv:2: effective_stress (empty): expected a number");
  refused("gas,0.01,2,5,1,\n", "p.csv:2: phase gas: expected solid or fluid");
  check_refused("phase,x,velocity,solid_velocity\nsolid,0,1,1\n",
                "p.csv:1: velocity and solid_velocity: expected a velocity only once",
                {.time = 1.0});
  // Without phases nobody knows whose velocity it is.
  check_refused("x,t,velocity\n0,1,1\n",
                "p.csv:1: no field: expected a column effective_stress, or");
}

BOOST_AUTO_TEST_CASE(values_that_cannot_be) {
  const std::string header = "x,t,volume,pore_pressure\n0,1,1,1\n";
  check_refused(header + "0.2,1,1,1\n", "p.csv:3: x 0.2: expected a number >= 0 and <= 0.1");
  check_refused(header + "-0.01,1,1,1\n", "p.csv:3: x -0.01: expected a number >= 0 and <= 0.1");
  check_refused(header + "nan,1,1,1\n", "p.csv:3: x nan: expected a number");
  check_refused(header + "0,-1,1,1\n", "p.csv:3: t -1: expected a number >= 0");
  check_refused(header + "0,inf,1,1\n", "p.csv:3: t inf: expected a number >= 0");
  check_refused(header + "0,1,0,1\n", "p.csv:3: volume 0: expected a number > 0");
  check_refused(header + "0,1,1,nan\n", "p.csv:3: pore_pressure nan: expected a number");
  check_refused(header + "0,1,1,\n", "p.csv:3: pore_pressure (empty): expected a number");
  check_refused("x,t,pore_pressure\n", "p.csv:2: no rows: expected at least one");
  check_refused("t,pore_pressure\n0,1\n", "p.csv:1: x is missing: expected a column x");
  check_refused("x,x,t,pore_pressure\n0,0,1,1\n", "p.csv:1: x appears twice");
  check_refused("x,t,pore_pressure,pore_pressure\n0,0,1,1\n",
                "p.csv:1: pore_pressure appears twice");
}

BOOST_AUTO_TEST_CASE(an_end_may_be_rounded_and_a_half_space_has_none) {
  const auto x = [](const std::string& text, const PointReading& reading) {
    return read("x,t,pore_pressure\n" + text + ",1,1\n", reading).profiles[0].x[0];
  };
  BOOST_TEST(x("0.10000000000000003", {.length = 0.1}) == 0.1);
  BOOST_TEST(x("-1e-17", {.length = 0.1}) == 0.0);
  BOOST_TEST(x("1e6", {}) == 1e6);
  check_refused("x,t,pore_pressure\n-1e-17,1,1\n", "p.csv:2: x -1e-17: expected a number >= 0", {});
}

BOOST_AUTO_TEST_SUITE_END()
