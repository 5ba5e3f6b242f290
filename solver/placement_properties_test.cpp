// What holds for every placement, count, gap and seed; RC_PARAMS="max_success=100000" tries that
// many columns.

#include <rapidcheck/boost_test.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "solver/placement.hpp"

BOOST_AUTO_TEST_SUITE(placement_properties)

using namespace porowave::solver;

namespace {

Discretization any_column() {
  Discretization d;
  d.elements = *rc::gen::inRange(1, 60);
  d.points_per_element = *rc::gen::inRange(1, 10);
  d.placement = static_cast<Placement>(*rc::gen::inRange(0, 4));
  d.jitter = *rc::gen::inRange(0, 101) / 100.0;
  d.seed = *rc::gen::arbitrary<std::uint64_t>();
  return d;
}

Phase any_phase() {
  return static_cast<Phase>(*rc::gen::inRange(0, 2));
}

// Some elements, any of them more than once.
std::vector<int> any_elements(const Discretization& d) {
  std::vector<int> elements(static_cast<std::size_t>(*rc::gen::inRange(0, 6)));
  for (int& element : elements) element = *rc::gen::inRange(0, d.elements);
  return elements;
}

}  // namespace

RC_BOOST_PROP(points_fill_the_column_and_stand_for_all_of_it, ()) {
  const Discretization d = any_column();
  const double spacing = std::ldexp(1.0, *rc::gen::inRange(-10, 5));
  const auto points = place_points(d, spacing, any_phase());
  const double length = d.elements * spacing;
  RC_ASSERT(points.x.size() == static_cast<std::size_t>(d.elements * d.points_per_element));
  RC_ASSERT(points.volume.size() == points.x.size());
  double volume = 0.0;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    RC_ASSERT(points.x[p] >= 0.0 && points.x[p] <= length);
    RC_ASSERT(points.volume[p] > 0.0);
    volume += points.volume[p];
  }
  RC_ASSERT(std::abs(volume - length) <= 1e-15 * length * static_cast<double>(points.x.size()));
}

RC_BOOST_PROP(every_cell_has_its_points_unless_they_are_random, ()) {
  Discretization d = any_column();
  if (d.placement == Placement::random) d.placement = Placement::stratified;
  const auto points = place_points(d, 1.0, any_phase());
  std::vector<int> count(static_cast<std::size_t>(d.elements), 0);
  for (const double x : points.x) {
    ++count[static_cast<std::size_t>(std::min(static_cast<int>(x), d.elements - 1))];
  }
  RC_ASSERT(std::ranges::all_of(count, [&](int n) { return n == d.points_per_element; }));
}

RC_BOOST_PROP(jittered_points_stay_within_half_their_share_of_the_spacing, ()) {
  Discretization d = any_column();
  d.placement = Placement::jittered;
  const auto points = place_points(d, 1.0, any_phase());
  const double half_share = 0.5 * d.jitter / d.points_per_element;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    const double regular = (static_cast<double>(p) + 0.5) / d.points_per_element;
    RC_ASSERT(std::abs(points.x[p] - regular) <= half_share + 1e-13);
  }
}

RC_BOOST_PROP(a_gap_takes_the_points_of_its_elements_and_touches_no_other, ()) {
  Discretization d = any_column();
  const double spacing = std::ldexp(1.0, *rc::gen::inRange(-10, 5));
  const Phase phase = any_phase();
  const auto whole = place_points(d, spacing, phase);
  const auto gaps = any_elements(d);
  for (const int element : gaps) d.empty_elements.push_back((element + 0.5) * spacing);
  const auto rest = place_points(d, spacing, phase);
  std::vector<double> expected;
  for (const double x : whole.x) {
    const int element = std::min(static_cast<int>(x / spacing), d.elements - 1);
    if (std::ranges::find(gaps, element) == gaps.end()) expected.push_back(x);
  }
  RC_CLASSIFY(!gaps.empty(), "with a gap");
  RC_ASSERT(rest.x == expected);
}

RC_BOOST_PROP(a_column_of_another_size_has_the_same_points_stretched, ()) {
  const Discretization d = any_column();
  const double stretch = std::ldexp(1.0, *rc::gen::inRange(-30, 31));
  const Phase phase = any_phase();
  const auto one = place_points(d, 1.0, phase);
  const auto other = place_points(d, stretch, phase);
  RC_ASSERT(one.x.size() == other.x.size());
  for (std::size_t p = 0; p < one.x.size(); ++p) RC_ASSERT(other.x[p] == one.x[p] * stretch);
}

BOOST_AUTO_TEST_SUITE_END()
