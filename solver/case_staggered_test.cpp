#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/case.hpp"
#include "solver/case_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(case_staggered)

namespace {

using namespace test;

// A case of the staggered scheme; `lines` stand from line 21 on in [discretization].
std::string staggered(const std::string& lines, const std::string& time = "") {
  return problem_only + "[discretization]\n" + lines +
         "\nelements = 200\nscheme = \"staggered4\"\n[time]\nend = 1\n" + time;
}

BOOST_AUTO_TEST_CASE(it_has_its_own_defaults) {
  const Discretization d = read(staggered("")).discretization;
  BOOST_CHECK(d.scheme == Scheme::staggered4);
  BOOST_CHECK(d.transfer == TransferName::mls);
  BOOST_TEST(to_string(d.kernel) == "wendland_c2");
  BOOST_TEST(d.basis_order == 2);
  BOOST_TEST(d.support_radius == 2.0);
  const Discretization cubic = read(staggered("basis_order = 3")).discretization;
  BOOST_TEST(cubic.basis_order == 3);
  BOOST_TEST(cubic.support_radius == 2.5);
  BOOST_TEST(read(staggered("")).time.order == 2);
  BOOST_CHECK(read(least).discretization.scheme == Scheme::galerkin);
}

BOOST_AUTO_TEST_CASE(what_fits_it_is_taken) {
  const Discretization d =
      read(staggered("kernel = \"bspline3\"\nsupport_radius = 3\ntransfer = \"mls\""))
          .discretization;
  BOOST_TEST(to_string(d.kernel) == "bspline3");
  BOOST_TEST(d.support_radius == 3.0);
  BOOST_TEST(read(staggered("support_radius = \"adaptive\"")).discretization.support_radius == 2.0);
  BOOST_TEST(read(staggered("", "time_order = 4\n")).time.order == 4);
  BOOST_TEST(message_for(staggered("", "flip = 1.0\npath = \"auto\"\n")) == "no error");
}

BOOST_AUTO_TEST_CASE(what_does_not_belong_to_it_is_refused) {
  const auto refused = [](const std::string& line, const std::string& expected) {
    BOOST_TEST(message_for(staggered(line)) ==
               "case.toml:21: [discretization] " + line + ": expected " + expected);
  };
  const std::string with_scheme = " with scheme = \"staggered4\"";
  refused("transfer = \"shape\"", "\"mls\"" + with_scheme);
  refused("strain = \"cell\"", "no strain" + with_scheme);
  refused("basis_order = 1", "a whole number from 2 to 3");
  refused("basis_order = 4", "a whole number from 2 to 3");
  refused("support_radius = 0.5", "a number >= 1 and <= 8");
  refused("support_radius = \"natural\"", "a number >= 1 and <= 8");
  BOOST_TEST(message_for(with("elements = 200", "elements = 7", staggered(""))) ==
             "case.toml:22: [discretization] elements = 7: expected at least 8" + with_scheme);
  BOOST_TEST(message_for(staggered("", "time_order = 3\n")) ==
             "case.toml:26: [time] time_order = 3: expected 2 or 4");
  BOOST_TEST(
      message_for(least + "time_order = 4\n")
          .ends_with("time_order = 4: expected no time_order unless scheme = \"staggered4\""));
  BOOST_TEST(message_for(staggered("", "flip = 0.5\n")) ==
             "case.toml:26: [time] flip = 0.5: expected 1" + with_scheme);
  BOOST_TEST(message_for(staggered("", "path = \"points\"\n")) ==
             "case.toml:26: [time] path = \"points\": expected \"auto\" or \"frozen\"" +
                 with_scheme + ", which eliminates the points");
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
