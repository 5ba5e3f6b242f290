#include "solver/stability/remedies.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "solver/case_fixtures.hpp"
#include "solver/stability/automatic_fixtures.hpp"
#include "solver/stability/automatic_step.hpp"

BOOST_AUTO_TEST_SUITE(remedies)

using namespace porowave;
using namespace porowave::solver;
using namespace porowave::solver::test;

namespace {

std::set<std::string> texts_of(const Case& scene) {
  std::set<std::string> texts;
  for (const Remedy& remedy : solver::remedies(scene)) texts.insert(remedy.text);
  return texts;
}

// A case file of these choices, read.
Discretization read_with(const std::string& lines) {
  return read(problem_only + "[discretization]\nelements = 40\n" + lines + "[time]\nend = 1e-5\n")
      .discretization;
}

bool same(const Discretization& a, const Discretization& b) {
  return a.scheme == b.scheme && a.support_radius == b.support_radius && a.strain == b.strain &&
         a.adaptive_support == b.adaptive_support && a.basis_order == b.basis_order &&
         a.points_per_element == b.points_per_element && a.placement == b.placement;
}

std::string lines_of_remedy(std::string text) {
  const std::string joint = " with ";
  const auto at = text.find(joint);
  if (at != std::string::npos) text.replace(at, joint.size(), "\n");
  return text + "\n";
}

}  // namespace

// As text and as a case they say the same, and a case file may say them beside the rest.
BOOST_AUTO_TEST_CASE(each_is_what_a_case_file_may_say) {
  const std::string points = "points_per_element = 2\nplacement = \"random\"\n";
  for (const std::string method :
       {"basis_order = 2\nsupport_radius = 2.5\n", "basis_order = 0\nstrain = \"recovered\"\n",
        "scheme = \"staggered4\"\nbasis_order = 3\n", "transfer = \"shape\"\n",
        "transfer = \"apic\"\n"}) {
    Case scene = read(problem_only + "[discretization]\nelements = 40\n" + points + method +
                      "[time]\nend = 1e-5\n");
    const auto list = solver::remedies(scene);
    BOOST_TEST(list.size() >= 3u);
    for (const Remedy& remedy : list) {
      std::string lines;
      for (const std::string& block : {points, method}) {
        std::string rest = block;
        while (!rest.empty()) {
          const std::string line = rest.substr(0, rest.find('\n') + 1);
          rest.erase(0, line.size());
          const std::string key = line.substr(0, line.find(' '));
          if (remedy.text.find(key) == std::string::npos) lines += line;
        }
      }
      BOOST_TEST_CONTEXT(method << remedy.text) {
        // basis_order = 2 of staggered4 comes with its own radius, which is also the default.
        BOOST_TEST(
            same(read_with(lines + lines_of_remedy(remedy.text)), remedy.scene.discretization));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_proposed_that_the_case_has) {
  Case scene = undamped_column(20, Placement::random, 8, 10.0);
  scene.discretization.strain = Strain::recovered;
  scene.discretization.adaptive_support = true;
  BOOST_CHECK((texts_of(scene) ==
               std::set<std::string>{"placement = \"stratified\"", "placement = \"uniform\""}));
}

// Every one that is named has a step of its own.
BOOST_AUTO_TEST_CASE(those_that_help_have_a_stable_step) {
  int scenes = 0, named = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Case scene = undamped_column(20, Placement::random, 1, 40.0);
    scene.discretization.seed = seed;
    const std::string text = remedies_that_help(scene, scene.time.end);
    ++scenes;
    for (const Remedy& remedy : solver::remedies(scene)) {
      if ((" " + text + " or ").find(" " + remedy.text + " or ") == std::string::npos) continue;
      ++named;
      BOOST_CHECK_NO_THROW(solver::automatic_step(remedy.scene));
    }
  }
  BOOST_TEST(named >= scenes);
}

BOOST_AUTO_TEST_SUITE_END()
