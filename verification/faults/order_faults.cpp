// Wrong estimators of the order, judged by tables whose order is known.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/faults/order_check.hpp"
#include "verification/order/convergence_fit.hpp"
#include "verification/order/manufactured_tables.hpp"

namespace porowave::verification::faults {

namespace {

using manufactured::halved;
using manufactured::noisy_table;
using manufactured::table_of;
using manufactured::unequal;

double square(double h) {
  return h * h;
}

bool finds(const OrderEstimate& estimate, double order, double tolerance) {
  return estimate.status == OrderStatus::observed && std::abs(estimate.order - order) <= tolerance;
}

struct OrderFact {
  std::string name;
  std::function<bool(const OrderFunction&)> holds;
};

const std::vector<OrderFact>& order_facts() {
  static const std::vector<OrderFact> all = {
      {"h² on grids halved has order 2",
       [](const auto& order_of) { return finds(order_of(table_of(halved, square)), 2.0, 1e-9); }},
      {"h² on grids of unequal ratios has order 2",
       [](const auto& order_of) { return finds(order_of(table_of(unequal, square)), 2.0, 1e-9); }},
      {"1/h has order -1",
       [](const auto& order_of) {
         return finds(order_of(table_of(halved, [](double h) { return 1.0 / h; })), -1.0, 1e-9);
       }},
      {"h² + 4e-5 has order 2 and a floor",
       [](const auto& order_of) {
         const auto found = order_of(table_of(halved, [](double h) { return h * h + 4e-5; }));
         return finds(found, 2.0, 1e-3) && std::abs(found.floor - 4e-5) < 1e-7;
       }},
      {"a hole in the table is no order",
       [](const auto& order_of) {
         ErrorTable table = table_of(halved, square);
         table.errors[2][0] = std::nan("");
         return order_of(table).status == OrderStatus::not_finite;
       }},
      {"errors that go up and down have no order",
       [](const auto& order_of) {
         int level = 0;
         return order_of(table_of(halved, [&](double h) {
                  return h * h * (++level % 2 == 0 ? 2.0 : 0.5);
                })).status == OrderStatus::not_asymptotic;
       }},
      {"two levels tell no order",
       [](const auto& order_of) {
         return order_of(table_of({0.2, 0.1}, square)).status == OrderStatus::too_few_levels;
       }},
      {"intervals hold the order in 90 of 100 noisy tables",
       [](const auto& order_of) {
         int held = 0;
         for (unsigned trial = 0; trial < 100; ++trial) {
           const auto found = order_of(noisy_table(halved, square, 0.15, 8, 1000 + trial));
           held += found.low <= 2.0 && 2.0 <= found.high;
         }
         return held >= 90;
       }},
  };
  return all;
}

OrderEstimate right(const ErrorTable& table) {
  return estimate_order(table, {.resamples = 200});
}

/// A plain regression, without any of the precautions.
OrderEstimate regression(const ErrorTable& table) {
  OrderEstimate result = right(table);
  if (result.status == OrderStatus::too_few_levels) return result;
  if (result.status == OrderStatus::not_finite) return result;
  result.status = OrderStatus::observed;
  result.order = fit_power(log_means(table)).order;
  return result;
}

Fault in_order(const std::string& what, const std::string& named, const OrderFunction& wrong) {
  return {"order", what, named, [wrong] { return caught_by_order_facts(wrong); }};
}

}  // namespace

Catch caught_by_order_facts(const OrderFunction& order_of) {
  for (const OrderFact& fact : order_facts()) {
    if (!fact.holds(order_of)) return {"facts of orders", "does not hold: " + fact.name};
  }
  return {"facts of orders", ""};
}

std::vector<Fault> order_faults() {
  return {
      in_order("every refinement is taken for a halving", "unequal ratios",
               [](const ErrorTable& table) {
                 ErrorTable other = table;
                 for (std::size_t i = 1; i < other.spacing.size(); ++i) {
                   other.spacing[i] = 0.5 * other.spacing[i - 1];
                 }
                 return right(other);
               }),
      in_order("logarithms of different bases", "halved has order 2",
               [](const ErrorTable& table) {
                 OrderEstimate e = right(table);
                 e.order /= std::log(10.0);
                 return e;
               }),
      in_order("the size of the order without its sign", "order -1",
               [](const ErrorTable& table) {
                 OrderEstimate e = right(table);
                 e.order = std::abs(e.order);
                 return e;
               }),
      in_order("no floor in the fit", "floor", regression),
      in_order("holes filled by the level before", "a hole",
               [](const ErrorTable& table) {
                 ErrorTable other = table;
                 for (std::size_t i = 1; i < other.errors.size(); ++i) {
                   for (std::size_t r = 0; r < other.errors[i].size(); ++r) {
                     double& e = other.errors[i][r];
                     if (std::isnan(e)) e = other.errors[i - 1][r];
                   }
                 }
                 return right(other);
               }),
      in_order("an order for every table, whatever its scatter", "up and down",
               [](const ErrorTable& table) {
                 const OrderEstimate e = right(table);
                 return e.status == OrderStatus::not_asymptotic ? regression(table) : e;
               }),
      in_order("only the two finest levels count", "two levels",
               [](const ErrorTable& table) {
                 OrderEstimate e = right(table);
                 if (e.status != OrderStatus::too_few_levels) return e;
                 e.status = OrderStatus::observed;
                 e.order = pairwise_orders(log_means(table)).back();
                 return e;
               }),
      in_order("intervals of half the width", "intervals",
               [](const ErrorTable& table) {
                 OrderEstimate e = right(table);
                 e.low = e.order - 0.5 * (e.order - e.low);
                 e.high = e.order + 0.5 * (e.high - e.order);
                 return e;
               }),
  };
}

}  // namespace porowave::verification::faults
