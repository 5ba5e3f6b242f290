// Which kernels, supports, strains and velocity updates go with which transfer.

#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/case_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(case_transfer)

namespace {

using namespace test;

// A case with these lines in [discretization] from line 21 on, and in [time] from its second.
std::string lines(const std::string& discretization, const std::string& time = "") {
  return problem_only + "[discretization]\n" + discretization +
         "\nelements = 8\n[time]\nend = 1\n" + time;
}

BOOST_AUTO_TEST_CASE(shape_takes_every_shape_function) {
  for (const std::string word : {"bspline1", "bspline2", "bspline3", "gimp", "cpgimp"}) {
    const Discretization d =
        read(lines("transfer = \"shape\"\nkernel = \"" + word + "\"")).discretization;
    BOOST_CHECK(d.transfer == TransferName::shape);
    BOOST_TEST(to_string(d.shape) == word);
    BOOST_TEST(kernel_word(d) == word);
  }
  BOOST_TEST(kernel_word(read(lines("transfer = \"shape\"")).discretization) == "bspline1");
  BOOST_TEST(kernel_word(read(lines("kernel = \"wendland_c2\"")).discretization) == "wendland_c2");
  BOOST_TEST(
      message_for(lines("kernel = \"wendland_c2\"\ntransfer = \"shape\"")) ==
      "case.toml:21: [discretization] kernel = \"wendland_c2\": expected one of \"bspline1\", "
      "\"bspline2\", \"bspline3\", \"gimp\", \"cpgimp\" with transfer = \"shape\"");
  BOOST_TEST(message_for(lines("support_radius = 1.5\ntransfer = \"shape\"\nkernel = "
                               "\"bspline2\"")) == "no error");
}

BOOST_AUTO_TEST_CASE(moving_least_squares_take_a_limit_of_the_condition) {
  BOOST_TEST(read(lines("")).discretization.max_condition == 1e4);
  BOOST_TEST(read(lines("max_condition = 50")).discretization.max_condition == 50.0);
  BOOST_TEST(
      message_for(lines("max_condition = 1")) ==
      "case.toml:21: [discretization] max_condition = 1: expected a number > 1 and <= 1e+12");
  BOOST_TEST(message_for(lines("max_condition = 50\ntransfer = \"shape\"")) ==
             "case.toml:21: [discretization] max_condition = 50: expected no max_condition with "
             "transfer = \"shape\", which has no basis");
  BOOST_TEST(message_for(lines("max_condition = 50\nscheme = \"staggered4\"")) ==
             "case.toml:21: [discretization] max_condition = 50: expected no max_condition with "
             "scheme = \"staggered4\"");
}

BOOST_AUTO_TEST_CASE(apic_takes_splines_and_is_quadratic_by_itself) {
  BOOST_TEST(kernel_word(read(lines("transfer = \"apic\"")).discretization) == "bspline2");
  BOOST_TEST(read(lines("transfer = \"apic\"")).time.flip == 0.0);
  for (const std::string word : {"bspline1", "bspline2", "bspline3"}) {
    BOOST_TEST(message_for(lines("transfer = \"apic\"\nkernel = \"" + word + "\"")) == "no error");
  }
  for (const std::string word : {"gimp", "cpgimp", "wendland_c2"}) {
    BOOST_TEST(message_for(lines("kernel = \"" + word + "\"\ntransfer = \"apic\"")) ==
               "case.toml:21: [discretization] kernel = \"" + word +
                   "\": expected one of \"bspline1\", \"bspline2\", \"bspline3\" with transfer = "
                   "\"apic\"");
  }
  BOOST_TEST(
      message_for(lines("basis_order = 1\ntransfer = \"apic\"")) ==
      "case.toml:21: [discretization] basis_order = 1: expected no basis_order with transfer "
      "= \"apic\", which has no basis");
  BOOST_TEST(message_for(lines("support_radius = \"adaptive\"\ntransfer = \"apic\"")) ==
             "case.toml:21: [discretization] support_radius = \"adaptive\": expected 1.5 with "
             "transfer = \"apic\", which has no other support");
  BOOST_TEST(
      message_for(lines("transfer = \"apic\"", "flip = 1.0\n")) ==
      "case.toml:25: [time] flip = 1: expected no flip with transfer = \"apic\", whose points "
      "take the velocity of the nodes and its gradient");
  BOOST_TEST(message_for(lines("transfer = \"apic\"", "xpic_order = 2\n"))
                 .starts_with("case.toml:25: [time] xpic_order = 2: expected no xpic_order with"));
}

BOOST_AUTO_TEST_CASE(domains_belong_to_shape) {
  for (const std::string word : {"gimp", "cpgimp"}) {
    BOOST_TEST(message_for(lines("kernel = \"" + word + "\"")) ==
               "case.toml:21: [discretization] kernel = \"" + word +
                   "\": expected one of \"bspline1\", \"bspline2\", \"bspline3\", \"wendland_c2\", "
                   "\"wendland_c4\", \"wendland_c6\" with transfer = \"mls\"");
  }
}

BOOST_AUTO_TEST_CASE(recovered_strains_need_linear_functions) {
  for (const std::string ok : {"transfer = \"mls\"", "transfer = \"shape\""}) {
    BOOST_TEST(message_for(lines("strain = \"recovered\"\n" + ok)) == "no error");
  }
  BOOST_TEST(
      message_for(lines("strain = \"recovered\"\ntransfer = \"apic\"")) ==
      "case.toml:21: [discretization] strain = \"recovered\": expected \"cell\" with transfer "
      "= \"apic\", whose strain is the affine field");
  for (const std::string word : {"bspline2", "gimp"}) {
    BOOST_TEST(
        message_for(
            lines("strain = \"recovered\"\ntransfer = \"shape\"\nkernel = \"" + word + "\"")) ==
        "case.toml:21: [discretization] strain = \"recovered\": expected \"cell\" with shape "
        "functions other than \"bspline1\", whose strain is not constant in a cell");
  }
}

BOOST_AUTO_TEST_CASE(xpic_takes_the_place_of_flip) {
  BOOST_TEST(read(lines("")).time.xpic_order == 0);
  const Case scene = read(lines("", "xpic_order = 2\n"));
  BOOST_TEST(scene.time.xpic_order == 2);
  BOOST_TEST(scene.time.flip == 1.0);
  BOOST_TEST(message_for(lines("", "flip = 0.9\nxpic_order = 2\n")) ==
             "case.toml:25: [time] flip = 0.9: expected no flip with xpic_order, which takes its "
             "place");
  for (const std::string bad : {"0", "11"}) {
    BOOST_TEST(message_for(lines("", "xpic_order = " + bad + "\n")) ==
               "case.toml:25: [time] xpic_order = " + bad +
                   ": expected a whole number from 1 to 10");
  }
}

BOOST_AUTO_TEST_CASE(frozen_is_for_points_that_can_be_eliminated) {
  const std::string frozen = "path = \"frozen\"\n";
  const std::string shape = "transfer = \"shape\"";
  for (const std::string& possible :
       {std::string(), shape, std::string("kernel = \"bspline3\""),
        std::string("strain = \"recovered\""), std::string("support_radius = \"adaptive\"")}) {
    BOOST_TEST((read(lines(possible, frozen)).time.path == StepPath::frozen));
  }
  for (const std::string impossible :
       {"transfer = \"apic\"", "transfer = \"shape\"\nkernel = \"bspline2\"",
        "transfer = \"shape\"\nkernel = \"cpgimp\""}) {
    const auto message = message_for(lines(impossible, frozen));
    BOOST_TEST(message.find("[time] path = \"frozen\": expected \"auto\" or \"points\": points can "
                            "be eliminated with") != std::string::npos);
    BOOST_TEST(message_for(lines(impossible, "path = \"auto\"\n")) == "no error");
  }
  BOOST_TEST(message_for(lines("", frozen + "xpic_order = 2\n"))
                 .starts_with("case.toml:25: [time] path = \"frozen\""));
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
