#include "verification/cluster/case_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>

#include "reference/problem/errors.hpp"
#include "verification/cost/cost_model.hpp"
#include "verification/study/build_identity.hpp"
#include "verification/study/case_identity.hpp"

namespace porowave::verification {

namespace {

constexpr std::size_t id_length = 32;

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> block;
  while (file.read(block.data(), block.size()) || file.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof()) throw InputError(path + ": cannot be read: expected a file");
  return text;
}

bool is_id(std::string_view text) {
  return text.size() == id_length && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

/// Calls `use` with id and the rest of each line.
template <class Use>
void for_each_line(const std::string& path, std::string_view text, Use use) {
  for (std::size_t begin = 0, number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    const std::string_view id = line.substr(0, line.find(' '));
    const std::string_view rest = line.substr(std::min(line.size(), id.size() + 1));
    if (!is_id(id) || !use(id, rest)) {
      throw InputError(fmt::format("{}:{}: {}: expected the id of a case, 32 hexadecimal digits",
                                   path, number, line));
    }
  }
}

}  // namespace

double CaseList::seconds() const {
  double sum = 0.0;
  for (const Entry& entry : entries) sum += static_cast<double>(entry.seconds);
  return sum;
}

CaseList case_list(const Study& study) {
  constexpr float seconds_of_another_solver = 1.0F;
  CaseList list;
  for (const StudyCase& one : study.cases) {
    CaseList::Entry entry{{},
                          study.adapter ? seconds_of_another_solver
                                        : static_cast<float>(predicted_seconds(one.scene))};
    std::copy_n(one.id.begin(), id_length, entry.id.begin());
    list.entries.push_back(entry);
  }
  std::sort(list.entries.begin(), list.entries.end(),
            [](const CaseList::Entry& a, const CaseList::Entry& b) { return a.id < b.id; });
  return list;
}

CaseList case_list(const std::string& study_path, const std::string& kept_in) {
  auto kept = read_case_list(kept_in, study_key(study_path));
  return kept ? std::move(*kept) : case_list(load_study(study_path));
}

bool stands_alone(const Study& study) {
  return !study.adapter &&
         std::none_of(study.cases.begin(), study.cases.end(), [](const StudyCase& one) {
           return one.scene.problem.load.shape() == LoadShape::table;
         });
}

std::string study_key(const std::string& study_path) {
  std::string costs;
  for (const CostTerms& of_family : cost_constants().solver) {
    fmt::format_to(std::back_inserter(costs), "{} ", fmt::join(of_family, " "));
  }
  fmt::format_to(std::back_inserter(costs), "{}", fmt::join(cost_constants().judging, " "));
  return text_hash(fmt::format("{}\n{}\n{}", numerics_hash(), costs, text_of(study_path)));
}

void write_case_list(const std::string& path, const CaseList& list, const std::string& key) {
  std::string text = fmt::format("# {}\n", key);
  for (const CaseList::Entry& entry : list.entries) {
    fmt::format_to(std::back_inserter(text), "{} {:.4g}\n", entry.id_text(), entry.seconds);
  }
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw EnvironmentError(path + ": cannot be written: expected a disk with space");
}

std::optional<CaseList> read_case_list(const std::string& path, const std::string& key) {
  std::ifstream head(path, std::ios::binary);
  std::string first;
  if (!std::getline(head, first) || first != "# " + key) return std::nullopt;
  CaseList list;
  const std::string text = text_of(path);
  list.entries.reserve(text.size() / id_length);
  for_each_line(path, text, [&](std::string_view id, std::string_view rest) {
    CaseList::Entry entry{};
    std::copy(id.begin(), id.end(), entry.id.begin());
    const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), entry.seconds);
    list.entries.push_back(entry);
    return read.ec == std::errc() && read.ptr == rest.data() + rest.size();
  });
  return list;
}

std::set<std::string> read_case_ids(const std::string& path) {
  std::set<std::string> ids;
  const std::string text = text_of(path);
  for_each_line(path, text, [&](std::string_view id, std::string_view) {
    ids.emplace_hint(ids.end(), id);
    return true;
  });
  return ids;
}

}  // namespace porowave::verification
