#include "reference/limits.hpp"

#include "reference/limits_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(limits)

using namespace porowave;
using namespace porowave::reference;
using namespace porowave::fixtures;

namespace {

constexpr double length = 0.1;

Column column_of(NearEnd near, FarEnd far) {
  if (far == FarEnd::half_space) return {{}, near, far};
  return {length, near, far};
}

std::vector<Column> all_columns() {
  std::vector<Column> columns;
  for (int near = 0; near < 4; ++near) {
    for (int far = 0; far < 4; ++far) {
      columns.push_back(column_of(static_cast<NearEnd>(near), static_cast<FarEnd>(far)));
    }
  }
  return columns;
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_drag_the_column_is_dalemberts) {
  // Every wave decays by theta t times a constant, so every field tends at first order.
  const double t = 3.6 * length / wave_speeds(sand()).p1;
  double worst = 0.0;
  for (const Column& column : all_columns()) {
    for (const LoadShape shape : {LoadShape::step, LoadShape::sin4_pulse}) {
      const Fall fall({1e-2, 1e-3, 1e-4, 1e-5}, [&](double drag) {
        const Problem problem{with_drag(sand(), drag, t), column, Load(shape, 3.0, 2.0 * t)};
        return deviation(problem, undamped(problem, 0.037, t), 0.037, t);
      });
      BOOST_TEST_CONTEXT(name(column.near) << " " << name(column.far) << " " << name(shape)) {
        for (std::size_t f = 0; f < 4; ++f) {
          worst = std::max(worst, std::abs(fall.order(f) - 1.0));
          BOOST_TEST(std::abs(fall.order(f) - 1.0) < 0.002);
          BOOST_TEST(fall.smallest(f) < 1e-4);
        }
      }
    }
  }
  BOOST_TEST_MESSAGE("without drag: order 1, off by at most " << worst);
}

/// Deviations from the rigidly coupled column at x = place, against 1/(theta T).
Fall fall_to_rigid_coupling(const Column& column, double place) {
  const double crossing = length / sand().undrained_speed();
  const double t = 1.8 * crossing;  // the wave is on its way back
  return {{1e-2, 1e-3, 1e-4, 1e-5}, [&](double inverse_drag) {
            const Problem problem{with_drag(sand(), 1.0 / inverse_drag, crossing), column,
                                  Load(LoadShape::sin4_pulse, 3.0, 2.5 * crossing)};
            return deviation(problem, rigidly_coupled(problem, place, t), place, t);
          }};
}

BOOST_AUTO_TEST_CASE(stiff_drag_leaves_one_wave_away_from_the_ends) {
  // First order: the undrained mode has lambda = s/c (1 + O(s/theta)), and a drained layer exerts
  // next to no total stress. Not so rigid_drained: fluid enters and leaves its layer at
  // O((theta T)^-1/2) of the wave's velocity, and so much less is reflected.
  for (const Column& column : all_columns()) {
    const Fall fall = fall_to_rigid_coupling(column, 0.045);
    const double expected = column.far == FarEnd::rigid_drained ? 0.5 : 1.0;
    BOOST_TEST_MESSAGE("stiff drag, " << name(column.near) << ", " << name(column.far) << ": orders"
                                      << fall.orders());
    for (std::size_t f = 0; f < 4; ++f) {
      BOOST_TEST(std::abs(fall.order(f) - expected) < 0.05);
      BOOST_TEST(fall.smallest(f) < (expected == 1.0 ? 1e-4 : 1e-2));
    }
  }
}

BOOST_AUTO_TEST_CASE(stiff_drag_leaves_a_diffusive_layer_at_the_loaded_end) {
  for (const NearEnd near : {NearEnd::drained_traction, NearEnd::fluid_pressure}) {
    // Pressure differs from the prescribed one by a share of the load however thin the layer; the
    // flow that this drives is kappa/mu times p over the layer's thickness, O((theta T)^-1/2).
    const Fall fall = fall_to_rigid_coupling(column_of(near, FarEnd::rigid_sealed), 0.0);
    BOOST_TEST_MESSAGE("layer at " << name(near) << ": orders" << fall.orders());
    BOOST_TEST(std::abs(fall.order(stress)) < 0.001);
    BOOST_TEST(std::abs(fall.order(pressure)) < 0.001);
    BOOST_TEST(std::abs(fall.order(solid) - 0.5) < 0.03);
    BOOST_TEST(std::abs(fall.order(fluid) - 0.5) < 0.03);
  }
  for (const NearEnd near : {NearEnd::sealed_traction, NearEnd::velocity}) {
    // The layer takes up the undrained wave's relative velocity, O(1/(theta T)).
    const Fall fall = fall_to_rigid_coupling(column_of(near, FarEnd::rigid_sealed), 0.0);
    BOOST_TEST_MESSAGE("layer at " << name(near) << ": orders" << fall.orders());
    BOOST_TEST(std::abs(fall.order(stress) - 0.5) < 0.03);
    BOOST_TEST(std::abs(fall.order(pressure) - 0.5) < 0.03);
    if (near == NearEnd::velocity) continue;  // prescribed in both
    BOOST_TEST(std::abs(fall.order(solid) - 1.0) < 0.03);
    BOOST_TEST(std::abs(fall.order(fluid) - 1.0) < 0.03);
  }
}

BOOST_AUTO_TEST_SUITE_END()
