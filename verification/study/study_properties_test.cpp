// What holds for every study: its cases are the product of its axes without what is excluded, each
// stands alone, and shards share them out. RC_PARAMS="max_success=10000" tries that many studies.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rapidcheck/boost_test.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <map>
#include <set>

#include "reference/problem/errors.hpp"
#include "verification/study/study.hpp"
#include "verification/sweep/sweep.hpp"

BOOST_AUTO_TEST_SUITE(study_properties)

using namespace porowave;
using namespace porowave::verification;

namespace {

constexpr const char* problem =
    "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
    "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\nintrinsic_permeability = 1.0e-11\n"
    "fluid_viscosity = 1.0e-3\n"
    "[column]\nlength = 0.1\nnear = \"drained_traction\"\nfar = \"rigid_sealed\"\n"
    "[load]\nshape = \"step\"\nmagnitude = 1.0\n"
    "[discretization]\nelements = 12\nplacement = \"jittered\"\n[time]\nend = "
    "1.0e-5\n[study]\nname = \"any\"\n";

// Keys that go together in any way, and what they may be.
const std::map<std::string, std::vector<std::string>>& choices() {
  static const std::map<std::string, std::vector<std::string>> all = {
      {"discretization.kernel",
       {"\"bspline1\"", "\"bspline2\"", "\"bspline3\"", "\"wendland_c4\""}},
      {"discretization.support_radius", {"2.0", "2.5", "3.25", "\"adaptive\""}},
      {"discretization.elements", {"10", "14", "20", "33"}},
      {"discretization.points_per_element", {"1", "2", "5"}},
      {"discretization.jitter", {"0.0", "0.125", "1.0"}},
      {"discretization.seed", {"1", "2", "7", "9007199254740991"}},
      {"discretization.empty_elements", {"[]", "[0.05]", "[0.041, 0.052]"}},
      {"time.courant", {"0.1", "0.5"}},
  };
  return all;
}

using Axes = std::vector<std::pair<std::string, std::vector<std::string>>>;

// Without an order of their own that a reader of the file could not see.
Axes any_axes() {
  Axes axes;
  for (const auto& [key, values] : choices()) {
    if (*rc::gen::inRange(0, 2) == 0) continue;
    const auto count = static_cast<std::ptrdiff_t>(
        *rc::gen::inRange(1, std::min(static_cast<int>(values.size()), 3) + 1));
    axes.push_back({key, {values.begin(), values.begin() + count}});
  }
  if (axes.empty()) axes.push_back({"time.courant", {"0.5"}});
  for (std::size_t i = axes.size() - 1; i > 0; --i) {
    std::swap(axes[i],
              axes[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(i) + 1))]);
  }
  return axes;
}

std::string text_of(const Axes& axes) {
  std::string text = "[axes]\n";
  for (const auto& [key, values] : axes) {
    text += fmt::format("\"{}\" = [{}]\n", key, fmt::join(values, ", "));
  }
  return text;
}

Study study_of(const std::string& rest) {
  return read_study(TomlDocument::parse(problem + rest, "study.toml"));
}

std::multiset<std::string> ids_of(const Study& study) {
  std::multiset<std::string> ids;
  for (const auto& one : study.cases) ids.insert(one.id);
  return ids;
}

}  // namespace

RC_BOOST_PROP(cases_are_as_many_as_the_product_and_all_different, ()) {
  const Axes axes = any_axes();
  std::size_t product = 1;
  for (const auto& axis : axes) product *= axis.second.size();
  const Study study = study_of(text_of(axes));
  RC_ASSERT(study.cases.size() == product);
  const auto ids = ids_of(study);
  RC_ASSERT(std::set(ids.begin(), ids.end()).size() == product);
}

RC_BOOST_PROP(a_specification_alone_is_the_same_case, ()) {
  const Study study = study_of(text_of(any_axes()));
  const auto& one = study.cases[static_cast<std::size_t>(
      *rc::gen::inRange(0, static_cast<int>(study.cases.size())))];
  const Study alone = read_study(
      TomlDocument::parse(one.specification + "[study]\nname = \"alone\"\n", "alone.toml"));
  RC_ASSERT(alone.cases.size() == 1U);
  RC_ASSERT(alone.cases[0].id == one.id);
}

RC_BOOST_PROP(the_order_of_the_axes_does_not_change_the_cases, ()) {
  Axes axes = any_axes();
  const auto ids = ids_of(study_of(text_of(axes)));
  std::ranges::reverse(axes);
  RC_ASSERT(ids_of(study_of(text_of(axes))) == ids);
}

RC_BOOST_PROP(excluding_a_value_leaves_the_study_without_it, ()) {
  Axes axes = any_axes();
  const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(axes.size())));
  auto& [key, values] = axes[at];
  // A list stands for any of its entries, so a value that is a list is put into one.
  const std::string excluded =
      fmt::format("{}[[exclude]]\n\"{}\" = [{}]\n", text_of(axes), key, values.front());
  values.erase(values.begin());
  if (values.empty()) {
    RC_ASSERT_THROWS_AS(study_of(excluded), InputError);
  } else {
    RC_ASSERT(ids_of(study_of(excluded)) == ids_of(study_of(text_of(axes))));
  }
}

RC_BOOST_PROP(shards_have_every_case_once, ()) {
  const Study study = study_of(text_of(any_axes()));
  const int count = *rc::gen::inRange(1, 9);
  std::multiset<std::string> ids;
  for (int index = 1; index <= count; ++index) {
    for (const StudyCase* one : cases_of(study, Shard{index, count})) ids.insert(one->id);
  }
  RC_ASSERT(ids == ids_of(study));
}

BOOST_AUTO_TEST_SUITE_END()
