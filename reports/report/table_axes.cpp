#include "reports/report/table_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace porowave::reports {

namespace {

constexpr auto by_default = "(default)";
/// Keys of which a smaller share of all combinations occurs change together.
constexpr double full_product = 0.75;

/// A key that varies: its values, and that of every case as an index.
struct Varying {
  std::string key;
  std::vector<std::string> values;
  std::vector<std::size_t> of_case;
};

std::string value_or_none(const CaseKeys& keys, const std::string& key) {
  const auto found = keys.find(key);
  return found == keys.end() ? by_default : shown(found->second);
}

Varying varying(const std::vector<CaseKeys>& cases, const std::string& key) {
  Varying result{key, {}, {}};
  std::set<std::string> values;
  for (const CaseKeys& keys : cases) values.insert(value_or_none(keys, key));
  result.values = in_natural_order({values.begin(), values.end()});
  std::map<std::string, std::size_t> index;
  for (std::size_t v = 0; v < result.values.size(); ++v) index[result.values[v]] = v;
  for (const CaseKeys& keys : cases) result.of_case.push_back(index[value_or_none(keys, key)]);
  return result;
}

bool change_together(const Varying& a, const Varying& b) {
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < a.of_case.size(); ++i) pairs.emplace(a.of_case[i], b.of_case[i]);
  return static_cast<double>(pairs.size()) <
         full_product * static_cast<double>(a.values.size() * b.values.size());
}

/// Sets of keys that change together, directly or by way of others.
std::vector<std::vector<std::size_t>> sets_of(const std::vector<Varying>& keys) {
  std::vector<std::size_t> set(keys.size());
  std::iota(set.begin(), set.end(), std::size_t{0});
  for (std::size_t a = 0; a < keys.size(); ++a) {
    for (std::size_t b = a + 1; b < keys.size(); ++b) {
      if (set[a] == set[b] || is_of_problem(keys[a].key) != is_of_problem(keys[b].key)) continue;
      if (!change_together(keys[a], keys[b])) continue;
      std::replace(set.begin(), set.end(), std::size_t{set[b]}, std::size_t{set[a]});
    }
  }
  std::vector<std::vector<std::size_t>> sets;
  for (std::size_t first = 0; first < keys.size(); ++first) {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      if (set[k] == first) members.push_back(k);
    }
    if (!members.empty()) sets.push_back(std::move(members));
  }
  return sets;
}

/// "shape, gimp", "bspline2, flip 0.99": of a method only what it sets, the words that say most
/// first and without their keys.
std::string method_name(const std::vector<Varying>& keys, const std::vector<std::size_t>& set,
                        std::size_t i) {
  std::string words;
  std::string others;
  for (const std::size_t k : set) {
    const std::string& value = keys[k].values[keys[k].of_case[i]];
    if (value == by_default) continue;
    const std::string key = short_name(keys[k].key);
    const bool speaks = key == "scheme" || key == "transfer" || key == "kernel";
    std::string& text = speaks ? words : others;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", speaks ? value : key + " " + value);
  }
  if (words.empty() && others.empty()) return by_default;
  return words.empty() || others.empty() ? words + others : words + ", " + others;
}

Varying combined(const std::vector<Varying>& keys, const std::vector<std::size_t>& set) {
  if (set.size() == 1) return keys[set.front()];
  std::vector<CaseKeys> names(keys.front().of_case.size());
  for (std::size_t i = 0; i < names.size(); ++i) names[i]["m"] = {method_name(keys, set, i)};
  return varying(names, "m");
}

}  // namespace

AxesOfTable axes_of(const std::vector<CaseKeys>& cases, const std::vector<std::string>& aside) {
  std::set<std::string> names;
  for (const CaseKeys& keys : cases) {
    for (const auto& [key, value] : keys) names.insert(key);
  }
  for (const std::string& key : aside) names.erase(key);
  AxesOfTable result;
  std::vector<Varying> keys;
  for (const std::string& key : names) {
    Varying one = varying(cases, key);
    if (one.values.size() == 1) {
      result.constants.emplace_back(key, one.values.front());
    } else {
      keys.push_back(std::move(one));
    }
  }
  auto sets = sets_of(keys);
  const auto of_problem = [&](const auto& set) { return is_of_problem(keys[set.front()].key); };
  std::stable_partition(sets.begin(), sets.end(), [&](const auto& s) { return !of_problem(s); });
  result.places.resize(cases.size());
  for (const auto& set : sets) {
    Varying axis = combined(keys, set);
    TableAxis shown_axis{{},
                         set.size() > 1 ? "method" : short_name(keys[set.front()].key),
                         axis.values,
                         of_problem(set)};
    if (set.size() > 1 && shown_axis.of_problem) shown_axis.title = "problem";
    for (const std::size_t k : set) shown_axis.keys.push_back(keys[k].key);
    const bool taken = std::any_of(result.axes.begin(), result.axes.end(),
                                   [&](const TableAxis& a) { return a.title == shown_axis.title; });
    if (taken) shown_axis.title = keys[set.front()].key;
    result.axes.push_back(std::move(shown_axis));
    for (std::size_t i = 0; i < cases.size(); ++i) result.places[i].push_back(axis.of_case[i]);
  }
  return result;
}

}  // namespace porowave::reports
