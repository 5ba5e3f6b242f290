#include "verification/study/study.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <set>

#include "reference/problem/errors.hpp"

BOOST_AUTO_TEST_SUITE(study)

using namespace porowave;
using namespace porowave::verification;

namespace {

const std::string base =
    "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
    "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\nintrinsic_permeability = 1.0e-11\n"
    "fluid_viscosity = 1.0e-3\n"
    "[column]\nlength = 0.1\nnear = \"drained_traction\"\nfar = \"rigid_sealed\"\n"
    "[load]\nshape = \"step\"\nmagnitude = 1.0\n"
    "[discretization]\nelements = 10\nkernel = \"bspline2\"\n"
    "[time]\nend = 1.0e-5\n[study]\nname = \"trial\"\n";  // 22 lines

Study study_of(const std::string& rest) {
  return read_study(TomlDocument::parse(base + rest, "study.toml"));
}

std::string message_of(const std::string& rest) {
  try {
    study_of(rest);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(cases_are_the_product_of_the_axes_the_last_one_fastest) {
  const Study study = study_of(
      "[axes]\n\"discretization.kernel\" = [\"bspline1\", \"wendland_c2\"]\n"
      "\"discretization.empty_elements\" = [[], [0.05]]\n"
      "\"discretization.seed\" = { first = 4, count = 3 }\n"
      "\"discretization.elements\" = [10, 20]\n[refine]\nby = \"discretization.elements\"\n");
  BOOST_REQUIRE(study.cases.size() == 24U);
  BOOST_TEST(study.refine.value() == 3U);
  BOOST_TEST(study.seed.value() == 2U);
  const auto& second = study.cases[1].scene.discretization;
  BOOST_TEST(second.elements == 20);
  BOOST_TEST(second.seed == 4U);
  const auto& last = study.cases[23].scene.discretization;
  BOOST_CHECK(last.kernel == solver::kernel_from_name("wendland_c2"));
  BOOST_TEST(last.empty_elements.size() == 1U);
  BOOST_TEST(last.seed == 6U);
  std::set<std::string> ids;
  for (const auto& one : study.cases) ids.insert(one.id);
  BOOST_TEST(ids.size() == 24U);
}

BOOST_AUTO_TEST_CASE(a_specification_is_a_case_file_with_the_same_identity) {
  const Study study =
      study_of("[axes]\n\"discretization.kernel\" = [\"bspline1\", \"bspline3\"]\n");
  const std::string text = study.cases[1].specification;
  const auto scene = solver::read_case(TomlDocument::parse(text, "case.toml"));
  BOOST_CHECK(scene.discretization.kernel == solver::kernel_from_name("bspline3"));
  const Study alone =
      read_study(TomlDocument::parse(text + "[study]\nname = \"other\"\n", "case.toml"));
  BOOST_TEST(alone.cases.size() == 1U);
  BOOST_TEST(alone.cases[0].id == study.cases[1].id);
}

BOOST_AUTO_TEST_CASE(methods_are_keys_that_change_together_under_a_name) {
  const std::string methods =
      "[[method]]\nname = \"mls\"\n\"discretization.basis_order\" = 2\n"
      "[[method]]\nname = \"uGIMP\"\n\"discretization.transfer\" = \"shape\"\n"
      "\"discretization.kernel\" = \"gimp\"\n";
  const Study study = study_of(methods +
                               "[axes]\n\"discretization.elements\" = [10, 20, 40]\n"
                               "[[exclude]]\n\"method\" = \"uGIMP\"\n"
                               "\"discretization.elements\" = 10\n");
  BOOST_REQUIRE(study.cases.size() == 5U);
  BOOST_TEST(study.axes[0].name() == "method");
  BOOST_TEST(study.cases[2].scene.discretization.basis_order == 2);
  BOOST_CHECK(study.cases[2].scene.discretization.transfer == solver::TransferName::mls);
  BOOST_CHECK(study.cases[3].scene.discretization.transfer == solver::TransferName::shape);
  BOOST_TEST(study.cases[3].scene.discretization.elements == 20);
  // The name is not part of what a case is.
  const Study plain = study_of("[axes]\n\"discretization.basis_order\" = [2]\n");
  BOOST_TEST(study.cases[0].id == plain.cases[0].id);
  const auto refused = [&](const std::string& rest, const std::string& words) {
    const std::string message = message_of(methods + rest);
    BOOST_TEST(message.find(words) != std::string::npos, message);
  };
  refused("[[method]]\nname = \"mls\"\n\"discretization.basis_order\" = 1\n",
          "no other [[method]]");
  refused("[[method]]\n\"discretization.basis_order\" = 1\n", "name");
  refused("[axes]\n\"discretization.kernel\" = [\"bspline1\"]\n", "no axis of [axes]");
  refused("[[method]]\nname = \"a\"\nbasis_order = 1\n", "a key of a case");
  refused("[[method]]\nname = \"mls again\"\n\"discretization.basis_order\" = 2\n",
          "appears twice");
  refused("[[method]]\nname = \"none\"\n\"discretization.kernel\" = \"gimp\"\n",
          "in the case method = \"none\"");
}

BOOST_AUTO_TEST_CASE(exclusions_need_all_their_values_and_lists_stand_for_any) {
  const std::string axes =
      "[axes]\n\"discretization.kernel\" = [\"bspline1\", \"bspline2\", \"bspline3\"]\n"
      "\"discretization.elements\" = [10, 20, 40]\n";
  BOOST_TEST(study_of(axes + "[[exclude]]\n\"discretization.kernel\" = \"bspline1\"\n"
                             "\"discretization.elements\" = [20.0, 40]\n"
                             "[[exclude]]\n\"discretization.elements\" = 10\n")
                 .cases.size() == 4U);
  BOOST_TEST(message_of(axes + "[[exclude]]\n\"discretization.kernel\" = \"gimp\"\n")
                 .find("study.toml:27: [exclude] discretization.kernel") == 0U);
  BOOST_TEST(message_of(axes + "[[exclude]]\n\"time.flip\" = 1\n")
                 .ends_with("expected a key that is an axis of [axes]"));
  BOOST_TEST(message_of(axes + "[[exclude]]\n\"discretization.elements\" = [10, 20, 40]\n")
                 .ends_with("leaves no case: expected at least one"));
}

BOOST_AUTO_TEST_CASE(wrong_studies_are_refused_with_the_line_of_the_value) {
  BOOST_TEST(message_of("[axes]\n\"discretization.kernel\" = [\"bspline1\",\n\"bspline\"]\n")
                 .find("study.toml:25: [discretization] kernel = \"bspline\": expected") == 0U);
  BOOST_TEST(message_of("[axes]\n\"discretization.transfer\" = [\"mls\", \"shape\"]\n"
                        "\"discretization.basis_order\" = [1]\n")
                 .find("leave it out by [[exclude]]") != std::string::npos);
  BOOST_TEST(message_of("[axes]\nkernel = [\"bspline1\"]\n").find("study.toml:24: [axes] kernel") ==
             0U);
  BOOST_TEST(message_of("[refine]\nby = \"discretization.elements\"\n")
                 .ends_with("expected the name of an axis of [axes]"));
  BOOST_TEST(message_of("[axes]\n\"discretization.kernel\" = [\"bspline1\"]\n[refine]\nby = "
                        "\"discretization.kernel\"\n")
                 .ends_with("expected an axis whose values are numbers"));
  BOOST_TEST(message_of("[axes]\n\"time.courant\" = [0.5, 0.25, 0.5]\n").find("appears twice") !=
             std::string::npos);
  BOOST_TEST(message_of("[axes]\n\"discretization.kernl\" = [1]\n").find("unknown key") !=
             std::string::npos);
}

// 2^16 values on four axes: as many cases as 64 bits cannot count.
BOOST_AUTO_TEST_CASE(more_cases_than_can_be_counted_are_refused) {
  std::string axes = "[axes]\n";
  for (const std::string key : {"seed", "elements", "points_per_element", "jitter"}) {
    axes += "\"discretization." + key + "\" = { first = 1, count = 65536 }\n";
  }
  BOOST_TEST(message_of(axes).find("cases or more: expected at most 10000000") != std::string::npos,
             message_of(axes));
}

// paper_case.toml is a case, paper_problem.toml a problem, the others are studies.
BOOST_AUTO_TEST_CASE(the_files_that_come_with_it_are_what_their_names_say) {
  std::set<std::string> found;
  for (const auto& entry :
       std::filesystem::directory_iterator(POROWAVE_SOURCE_DIR "/verification/studies")) {
    const std::string path = entry.path().string();
    if (entry.path().extension() != ".toml") continue;
    BOOST_TEST_CONTEXT(path) {
      if (path.ends_with("_case.toml")) {
        BOOST_CHECK_NO_THROW(solver::load_case(path));
      } else if (path.ends_with("_problem.toml")) {
        BOOST_CHECK_NO_THROW(load_problem(path));
      } else {
        BOOST_CHECK_NO_THROW(found.insert(load_study(path).name));
      }
    }
  }
  const std::set<std::string> needed = {"nightly", "paper", "pull_request", "smoke"};
  BOOST_TEST(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
}

BOOST_AUTO_TEST_SUITE_END()
