#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "verification/study/study.hpp"

namespace porowave::verification {

/// Cases by identity, with the CPU time that each is predicted to take, s.
struct CaseList {
  struct Entry {
    std::array<char, 32> id;
    float seconds;
    std::string_view id_text() const { return {id.data(), id.size()}; }
  };
  std::vector<Entry> entries;  ///< in the order of their ids
  double seconds() const;
};

/// All cases of a study. One that another solver runs is predicted to take a second.
CaseList case_list(const Study& study);

/// The cases of a study as kept in a file, if they are those of this study file and this program;
/// else made from the study, which takes 40 µs a case. Throws InputError.
CaseList case_list(const std::string& study_path, const std::string& kept_in);

/// What a study's list of cases depends on: the study file, and the program's numerics and cost
/// model. Throws InputError if the file cannot be read.
std::string study_key(const std::string& study_path);

/// That no other file decides what the cases of the study are.
bool stands_alone(const Study& study);

/// A text file: "# key", then a line "id seconds" for every case. Throws EnvironmentError.
void write_case_list(const std::string& path, const CaseList& list, const std::string& key);
/// None if there is no such file or its key is another. Throws InputError for a line that is wrong.
std::optional<CaseList> read_case_list(const std::string& path, const std::string& key);

/// The first word of every line, which must be the id of a case; lines that begin with # and empty
/// ones are left out. Throws InputError.
std::set<std::string> read_case_ids(const std::string& path);

}  // namespace porowave::verification
