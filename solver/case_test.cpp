#include "solver/case.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "reference/problem/errors.hpp"
#include "solver/case_fixtures.hpp"

namespace porowave::solver {

// The suite is named as its stem, which is a keyword and cannot name the namespace that
// BOOST_AUTO_TEST_SUITE makes; these two lines are what that macro stands for.
namespace case_suite {
BOOST_AUTO_TU_REGISTRAR(case_suite)
("case", __FILE__, __LINE__, boost::unit_test::decorator::collector_t::instance());

namespace {

using namespace test;

BOOST_AUTO_TEST_CASE(a_full_case_is_read_with_all_its_values) {
  const Case scene = read(full);
  BOOST_TEST(scene.problem.material.grain_density == 2650.0);
  BOOST_TEST(scene.problem.column.length.value() == 0.1);
  BOOST_TEST(name(scene.problem.column.near) == "sealed_traction");
  BOOST_TEST(name(scene.problem.column.far) == "rigid_drained");
  BOOST_TEST(scene.problem.load.magnitude() == 2.0);
  const Discretization& d = scene.discretization;
  BOOST_TEST(d.elements == 200);
  BOOST_CHECK(d.transfer == TransferName::mls);
  BOOST_TEST(to_string(d.kernel) == "wendland_c4");
  BOOST_TEST(d.support_radius == 2.75);
  BOOST_TEST(d.basis_order == 2);
  BOOST_TEST(d.points_per_element == 3);
  BOOST_TEST(name(d.placement) == "jittered");
  BOOST_TEST(d.jitter == 0.25);
  BOOST_TEST(d.seed == 12345678901U);
  BOOST_TEST(d.empty_elements == (std::vector<double>{0.05, 0.0}),
             boost::test_tools::per_element());
  BOOST_TEST(scene.time.end == 4.0e-5);
  BOOST_TEST(scene.time.courant == 0.25);
  BOOST_TEST(scene.time.flip == 0.75);
}

BOOST_AUTO_TEST_CASE(what_is_absent_has_its_default) {
  const Case scene = read(least);
  const Discretization& d = scene.discretization;
  BOOST_TEST(d.elements == 2);
  BOOST_CHECK(d.transfer == TransferName::mls);
  BOOST_TEST(to_string(d.kernel) == "bspline2");
  BOOST_TEST(d.support_radius == 1.5);
  BOOST_TEST(d.basis_order == 1);
  BOOST_TEST(d.points_per_element == 4);
  BOOST_TEST(name(d.placement) == "uniform");
  BOOST_TEST(d.jitter == 0.5);
  BOOST_TEST(d.seed == 1U);
  BOOST_TEST(d.empty_elements.empty());
  BOOST_TEST(scene.time.end == 1.0);
  BOOST_TEST(scene.time.courant == 0.5);
  BOOST_TEST(scene.time.flip == 1.0);
}

BOOST_AUTO_TEST_CASE(every_word_of_the_interface_means_what_it_says) {
  for (const auto& [kernel, radius] :
       {std::pair("bspline1", 1.0), std::pair("bspline2", 1.5), std::pair("bspline3", 2.0),
        std::pair("wendland_c2", 2.0), std::pair("wendland_c4", 2.0),
        std::pair("wendland_c6", 2.0)}) {
    const Case scene = read(with("support_radius = 2.75", "",
                                 with("\"wendland_c4\"", "\"" + std::string(kernel) + "\"")));
    BOOST_TEST(to_string(scene.discretization.kernel) == kernel);
    BOOST_TEST(scene.discretization.support_radius == radius);
  }
  for (const std::string placement : {"uniform", "stratified", "random"}) {
    const Case scene = read(with("jitter = 0.25", "", with("jittered", placement)));
    BOOST_TEST(name(scene.discretization.placement) == placement);
  }
  for (int order = 0; order <= 2; ++order) {
    const Case scene = read(with("basis_order = 2", "basis_order = " + std::to_string(order)));
    BOOST_TEST(scene.discretization.basis_order == order);
  }
  BOOST_TEST(message_for(with("path = \"points\"", "path = \"auto\"")) == "no error");
  BOOST_CHECK(read(full).discretization.strain == Strain::cell);
  BOOST_CHECK(read(with("\"cell\"", "\"recovered\"")).discretization.strain == Strain::recovered);
}

BOOST_AUTO_TEST_CASE(an_adaptive_support_starts_from_the_natural_one) {
  BOOST_TEST(!read(full).discretization.adaptive_support);
  const Discretization d = read(with("2.75", "\"adaptive\"")).discretization;
  BOOST_TEST(d.adaptive_support);
  BOOST_TEST(d.support_radius == 2.0);
}

BOOST_AUTO_TEST_CASE(ends_of_ranges_belong_to_them) {
  for (const auto& [from, to] :
       {std::pair("elements = 200", "elements = 10000000"),
        std::pair("support_radius = 2.75", "support_radius = 200"),
        std::pair("points_per_element = 3", "points_per_element = 1"),
        std::pair("points_per_element = 3", "points_per_element = 1000"),
        std::pair("jitter = 0.25", "jitter = 0"), std::pair("jitter = 0.25", "jitter = 1"),
        std::pair("seed = 12345678901", "seed = 0"),
        std::pair("seed = 12345678901", "seed = 9223372036854775807"),
        std::pair("[0.05, 0]", "[0.1, 0]"), std::pair("[0.05, 0]", "[]"),
        std::pair("courant = 0.25", "courant = 1"), std::pair("flip = 0.75", "flip = 0"),
        std::pair("flip = 0.75", "flip = 1")}) {
    BOOST_TEST_CONTEXT(to) BOOST_TEST(refusal(from, to) == "no error");
  }
  const auto spacing = with("points_per_element = 3", "points_per_element = 4");
  BOOST_TEST(message_for(with("2.75", "0.25", spacing)) == "no error");
}

BOOST_AUTO_TEST_CASE(the_shape_transfer_is_the_linear_shape_functions) {
  const auto shape = with("elements = 2", "elements = 2\ntransfer = \"shape\"", least);
  for (const std::string more :
       {"", "kernel = \"bspline1\"\n", "support_radius = 1.0\n", "support_radius = 1\n"}) {
    const Discretization d = read(with("[time]", more + "[time]", shape)).discretization;
    BOOST_CHECK(d.transfer == TransferName::shape);
    BOOST_TEST(to_string(d.kernel) == "bspline1");
    BOOST_TEST(d.support_radius == 1.0);
    BOOST_TEST(d.basis_order == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_file_is_read_and_named_in_messages) {
  const auto path = (std::filesystem::temp_directory_path() / "porowave_case_test.toml").string();
  std::ofstream(path) << full;
  BOOST_TEST(load_case(path).discretization.elements == 200);
  std::ofstream(path) << with("flip = 0.75", "flip = 2");
  BOOST_CHECK_EXCEPTION(load_case(path), InputError, [&](const InputError& error) {
    return error.what() == path + ":37: [time] flip = 2: expected a number >= 0 and <= 1";
  });
  std::filesystem::remove(path);
  BOOST_CHECK_EXCEPTION(load_case(path), InputError, [&](const InputError& error) {
    return error.what() == path + ": cannot be read: expected a TOML file";
  });
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
