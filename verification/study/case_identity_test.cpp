#include "verification/study/case_identity.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/toml_document.hpp"
#include "verification/study/build_identity.hpp"

BOOST_AUTO_TEST_SUITE(case_identity)

using namespace porowave;
using namespace porowave::verification;

BOOST_AUTO_TEST_CASE(hashes_are_those_published_for_fnv_1a) {
  BOOST_TEST(text_hash("") == "6c62272e07bb014262b821756295c58d");
  BOOST_TEST(text_hash("a") == "d228cb696f1a8caf78912b704e4a8964");
  BOOST_TEST(text_hash("foobar") == "343e1662793c64bf6f0d3597ba446f18");
}

BOOST_AUTO_TEST_CASE(the_content_of_a_load_table_belongs_to_the_identity) {
  solver::Case scene;
  scene.problem.load = Load(1.0, {0.0, 1.0}, {0.0, 1.0});
  const std::string one = case_id("text", scene);
  BOOST_TEST(case_id("text", scene) == one);
  BOOST_TEST(case_id("texts", scene) != one);
  scene.problem.load = Load(1.0, {0.0, 1.0}, {0.0, 1.0 + 1e-15});
  BOOST_TEST(case_id("text", scene) != one);
}

BOOST_AUTO_TEST_CASE(a_build_knows_itself) {
  BOOST_TEST(numerics_hash().size() == 64U);
  BOOST_TEST(!program_version().empty());
  BOOST_TEST(!compiler().empty());
  BOOST_TEST(!git_state().empty());
}

BOOST_AUTO_TEST_SUITE_END()
