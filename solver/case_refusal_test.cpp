#include "solver/case.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <string>

#include "solver/case_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(case_refusal)

namespace {

using namespace test;

// The case with the shape transfer, and `line` as line 21 of [discretization].
std::string shape_refusal(const std::string& line) {
  return message_for(problem_only + "[discretization]\n" + line +
                     "\nelements = 2\ntransfer = \"shape\"\n[time]\nend = 1\n");
}

void check_ranges_of_elements() {
  const std::string elements = ": expected a whole number from 2 to 10000000";
  BOOST_TEST(refusal("elements = 200", "elements = 0") ==
             "case.toml:21: [discretization] elements = 0" + elements);
  BOOST_TEST(refusal("elements = 200", "elements = 1") ==
             "case.toml:21: [discretization] elements = 1" + elements);
  BOOST_TEST(refusal("elements = 200", "elements = 10000001") ==
             "case.toml:21: [discretization] elements = 10000001" + elements);
  BOOST_TEST(refusal("elements = 200", "elements = -5") ==
             "case.toml:21: [discretization] elements = -5" + elements);
  BOOST_TEST(refusal("elements = 200\n", "\n") ==
             "case.toml: [discretization] elements is missing" + elements);
}

void check_ranges_of_discretization() {
  BOOST_TEST(refusal("support_radius = 2.75", "support_radius = 0.25") ==
             "case.toml:24: [discretization] support_radius = 0.25: expected a number >= 0.333333 "
             "and <= 200: from the point spacing of 0.333333 to the 200 elements of the column");
  BOOST_TEST(refusal("support_radius = 2.75", "support_radius = 201") ==
             "case.toml:24: [discretization] support_radius = 201: expected a number >= 0.333333 "
             "and <= 200: from the point spacing of 0.333333 to the 200 elements of the column");
  BOOST_TEST(refusal("support_radius = 2.75", "support_radius = nan") ==
             "case.toml:24: [discretization] support_radius = nan: expected a number");
  BOOST_TEST(refusal("basis_order = 2", "basis_order = 3") ==
             "case.toml:25: [discretization] basis_order = 3: expected a whole number from 0 to 2");
  BOOST_TEST(refusal("basis_order = 2", "basis_order = -1") ==
             "case.toml:25: [discretization] basis_order = -1: expected a whole number from 0 to "
             "2");
  BOOST_TEST(refusal("points_per_element = 3", "points_per_element = 0") ==
             "case.toml:26: [discretization] points_per_element = 0: expected a whole number from "
             "1 to 1000");
  BOOST_TEST(refusal("points_per_element = 3", "points_per_element = 1001") ==
             "case.toml:26: [discretization] points_per_element = 1001: expected a whole number "
             "from 1 to 1000");
  BOOST_TEST(refusal("jitter = 0.25", "jitter = 1.5") ==
             "case.toml:28: [discretization] jitter = 1.5: expected a number >= 0 and <= 1");
  BOOST_TEST(refusal("jitter = 0.25", "jitter = -0.5") ==
             "case.toml:28: [discretization] jitter = -0.5: expected a number >= 0 and <= 1");
  BOOST_TEST(refusal("seed = 12345678901", "seed = -1") ==
             "case.toml:29: [discretization] seed = -1: expected a whole number from 0 to " +
                 std::to_string(std::numeric_limits<long>::max()));
}

void check_ranges_of_time() {
  BOOST_TEST(refusal("end = 4.0e-5", "end = -1.0") ==
             "case.toml:35: [time] end = -1: expected a number > 0");
  BOOST_TEST(refusal("end = 4.0e-5", "end = 0") ==
             "case.toml:35: [time] end = 0: expected a number > 0");
  BOOST_TEST(refusal("end = 4.0e-5", "end = inf") ==
             "case.toml:35: [time] end = inf: expected a number > 0");
  BOOST_TEST(refusal("end = 4.0e-5\n", "\n") ==
             "case.toml: [time] end is missing: expected a number > 0");
  const std::string courant = ": expected a number > 0 and <= 1";
  BOOST_TEST(refusal("courant = 0.25", "courant = 0") ==
             "case.toml:36: [time] courant = 0" + courant);
  BOOST_TEST(refusal("courant = 0.25", "courant = 1.5") ==
             "case.toml:36: [time] courant = 1.5" + courant);
  BOOST_TEST(refusal("courant = 0.25", "courant = nan") ==
             "case.toml:36: [time] courant = nan" + courant);
  BOOST_TEST(refusal("flip = 0.75", "flip = 1.1") ==
             "case.toml:37: [time] flip = 1.1: expected a number >= 0 and <= 1");
  BOOST_TEST(refusal("flip = 0.75", "flip = -0.1") ==
             "case.toml:37: [time] flip = -0.1: expected a number >= 0 and <= 1");
}

BOOST_AUTO_TEST_CASE(the_shape_transfer_refuses_what_belongs_to_mls) {
  BOOST_TEST(shape_refusal("kernel = 1") ==
             "case.toml:21: [discretization] kernel = 1: expected a string");
  const std::string radius = ": expected 1 with transfer = \"shape\", which has no other support";
  BOOST_TEST(shape_refusal("support_radius = 1.5") ==
             "case.toml:21: [discretization] support_radius = 1.5" + radius);
  BOOST_TEST(shape_refusal("support_radius = \"adaptive\"") ==
             "case.toml:21: [discretization] support_radius = \"adaptive\"" + radius);
  BOOST_TEST(shape_refusal("basis_order = 0") ==
             "case.toml:21: [discretization] basis_order = 0: expected no basis_order with "
             "transfer = \"shape\", which has no basis");
}

BOOST_AUTO_TEST_CASE(numbers_out_of_range_are_refused) {
  check_ranges_of_elements();
  check_ranges_of_discretization();
  check_ranges_of_time();
}

// Points are numbered by a 32-bit integer.
BOOST_AUTO_TEST_CASE(more_points_than_can_be_numbered_are_refused) {
  const auto many = with("elements = 200", "elements = 10000000");
  BOOST_TEST(message_for(with("points_per_element = 3", "points_per_element = 214", many)) ==
             "no error");
  BOOST_TEST(message_for(with("points_per_element = 3", "points_per_element = 215", many)) ==
             "case.toml:26: [discretization] points_per_element = 215: expected a whole number "
             "from 1 to 214");
}

BOOST_AUTO_TEST_CASE(empty_elements_are_inside_the_column) {
  const std::string expected = ": expected a list, each entry a number >= 0 and <= 0.1";
  BOOST_TEST(refusal("[0.05, 0]", "[0.0625, 0.25]") ==
             "case.toml:30: [discretization] empty_elements = [ 0.0625, 0.25 ]" + expected);
  BOOST_TEST(refusal("[0.05, 0]", "[-0.125]") ==
             "case.toml:30: [discretization] empty_elements = [ -0.125 ]" + expected);
  BOOST_TEST(refusal("[0.05, 0]", "0.05") ==
             "case.toml:30: [discretization] empty_elements = 0.05" + expected);
  BOOST_TEST(refusal("[0.05, 0]", "[\"0.05\"]").ends_with(expected));
  // A half-space has no end that could be exceeded.
  const auto half_space = with("length = 0.1", "", with("rigid_drained", "half_space"));
  BOOST_TEST(message_for(with("[0.05, 0]", "[7.0]", half_space)) == "no error");
  BOOST_TEST(message_for(with("[0.05, 0]", "[-7.0]", half_space))
                 .ends_with(": expected a list, each entry a number >= 0"));
}

BOOST_AUTO_TEST_CASE(unknown_words_are_refused_with_the_known_ones) {
  const std::string kernels =
      ": expected one of bspline1, bspline2, bspline3, wendland_c2, wendland_c4, wendland_c6";
  BOOST_TEST(refusal("\"wendland_c4\"", "\"gauss\"") ==
             "case.toml:23: [discretization] kernel = \"gauss\"" + kernels);
  BOOST_TEST(refusal("\"wendland_c4\"", "\"bsplin3\"") ==
             "case.toml:23: [discretization] kernel = \"bsplin3\"" + kernels +
                 " (did you mean bspline3?)");
  BOOST_TEST(
      refusal("\"mls\"", "\"lagrange\"") ==
      "case.toml:22: [discretization] transfer = \"lagrange\": expected one of shape, mls, apic");
  BOOST_TEST(refusal("\"jittered\"", "\"halton sequence\"") ==
             "case.toml:27: [discretization] placement = \"halton sequence\": expected one of "
             "uniform, jittered, stratified, random");
  BOOST_TEST(refusal("\"cell\"", "\"nodal average\"") ==
             "case.toml:31: [discretization] strain = \"nodal average\": expected one of cell, "
             "recovered");
  BOOST_TEST(refusal("\"galerkin\"", "\"collocation\"") ==
             "case.toml:32: [discretization] scheme = \"collocation\": expected one of galerkin, "
             "staggered4");
  BOOST_TEST(
      refusal("\"points\"", "\"quick and dirty\"") ==
      "case.toml:38: [time] path = \"quick and dirty\": expected one of auto, points, frozen");
}

BOOST_AUTO_TEST_CASE(values_of_a_wrong_type_are_refused) {
  const auto start = [](int line, const std::string& rest) {
    return "case.toml:" + std::to_string(line) + ": " + rest;
  };
  BOOST_TEST(refusal("elements = 200", "elements = \"200\"") ==
             start(21,
                   "[discretization] elements = \"200\": expected a whole number from 2 to "
                   "10000000"));
  BOOST_TEST(refusal("elements = 200", "elements = 200.5") ==
             start(21,
                   "[discretization] elements = 200.5: expected a whole number from 2 to "
                   "10000000"));
  BOOST_TEST(refusal("\"mls\"", "1") ==
             start(22, "[discretization] transfer = 1: expected one of shape, mls, apic"));
  BOOST_TEST(refusal("2.75", "\"2.75\"") ==
             start(24,
                   "[discretization] support_radius = \"2.75\": expected a number or "
                   "\"adaptive\""));
  BOOST_TEST(refusal("2.75", "true") ==
             start(24, "[discretization] support_radius = true: expected a number"));
  BOOST_TEST(refusal("basis_order = 2", "basis_order = 2.0") ==
             start(25, "[discretization] basis_order = 2: expected a whole number from 0 to 2"));
  BOOST_TEST(refusal("\"jittered\"", "3") ==
             start(27,
                   "[discretization] placement = 3: expected one of uniform, jittered, "
                   "stratified, random"));
  BOOST_TEST(refusal("jitter = 0.25", "jitter = \"0.25\"") ==
             start(28, "[discretization] jitter = \"0.25\": expected a number >= 0 and <= 1"));
  BOOST_TEST(refusal("end = 4.0e-5", "end = \"4e-5\"") ==
             start(35, "[time] end = \"4e-5\": expected a number > 0"));
  BOOST_TEST(refusal("courant = 0.25", "courant = \"0.25\"") ==
             start(36, "[time] courant = \"0.25\": expected a number > 0 and <= 1, or \"auto\""));
  BOOST_TEST(refusal("courant = 0.25", "courant = \"automatic\"") ==
             start(36,
                   "[time] courant = \"automatic\": expected a number > 0 and <= 1, or "
                   "\"auto\""));
  BOOST_TEST(refusal("courant = 0.25", "courant = true") ==
             start(36, "[time] courant = true: expected a number > 0 and <= 1"));
  BOOST_TEST(refusal("flip = 0.75", "flip = false") ==
             start(37, "[time] flip = false: expected a number >= 0 and <= 1"));
}

BOOST_AUTO_TEST_CASE(keys_that_do_not_belong_together_are_refused) {
  for (const std::string placement : {"uniform", "stratified", "random"}) {
    BOOST_TEST(refusal("jittered", placement) ==
               "case.toml:28: [discretization] jitter = 0.25: expected no jitter unless placement "
               "= \"jittered\"");
  }
}

BOOST_AUTO_TEST_CASE(unknown_keys_and_tables_are_refused_with_a_suggestion) {
  BOOST_TEST(refusal("seed = 12345678901", "sed = 1") ==
             "case.toml:29: [discretization] sed = 1: unknown key; did you mean seed?");
  BOOST_TEST(refusal("courant = 0.25", "courrant = 0.25") ==
             "case.toml:36: [time] courrant = 0.25: unknown key; did you mean courant?");
  BOOST_TEST(refusal("courant = 0.25", "tolerance_of_all = 1") ==
             "case.toml:36: [time] tolerance_of_all = 1: unknown key; expected one of courant, "
             "end, flip, path, time_order, xpic_order");
  BOOST_TEST(refusal("[time]", "[tiem]") ==
             "case.toml:34: [tiem]: unknown table; did you mean time?");
  BOOST_TEST(refusal("[material]", "speed = 1\n[material]")
                 .starts_with("case.toml:1: speed: unknown top-level key"));
}

BOOST_AUTO_TEST_CASE(tables_of_a_study_do_not_belong_into_a_case) {
  const std::string known = "; expected one of material, column, load, discretization, time";
  BOOST_TEST(message_for(full + "\n[study]\nname = \"paper\"\n") ==
             "case.toml:40: [study]: unknown table" + known);
  BOOST_TEST(message_for(full + "\n[refine]\nby = \"discretization.elements\"\n") ==
             "case.toml:40: [refine]: unknown table" + known);
}

BOOST_AUTO_TEST_CASE(the_problem_is_checked_as_well) {
  BOOST_TEST(refusal("porosity = 0.4", "porosity = 1.2") ==
             "case.toml:2: [material] porosity = 1.2: expected a number > 0 and < 1");
  BOOST_TEST(message_for("").starts_with("case.toml: [material] "));
  BOOST_TEST(message_for(problem_only) ==
             "case.toml: [discretization] elements is missing: expected a whole number from 2 to "
             "10000000");
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
