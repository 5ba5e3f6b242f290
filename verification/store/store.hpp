#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "verification/store/database.hpp"
#include "verification/store/record.hpp"

namespace porowave::verification {

/// Results of cases in one SQLite file: table `cases`, one row a case, keyed by its id; table
/// `provenance`. A row is written whole or not at all, also under kill -9; writing a case twice
/// changes nothing. Several processes may use one store at a time.
///
/// Every measure is a column of its name. A store whose program knew fewer measures is read as it
/// is (what was not measured is NaN), and gets the missing columns when it is opened for writing:
/// old rows stay, and are rows of that program. Columns that this program does not know stay too,
/// and come along when stores are merged.
class Store {
 public:
  /// How a new store is kept from harm. A write-ahead log is faster, but all programs that use it
  /// must be on one machine; a rollback journal also serves on network file systems. A store that
  /// is there keeps its rollback journal only while nobody opens it with the other.
  enum class Journal { write_ahead, rollback };

  /// Throws InputError if the file is no store or of a newer version, EnvironmentError if it cannot
  /// be read or written.
  static Store create_or_open(const std::string& path, Journal journal = Journal::write_ahead);
  static Store open(const std::string& path);

  /// Adds rows in one transaction. A row that is there already is replaced only if it had failed.
  void add(const std::vector<Record>& records);
  void add(const Provenance& provenance);

  /// Ids of the cases that need not be run again: all whose status is not `failed`.
  std::set<std::string> finished_ids() const;
  bool finished(const std::string& id) const;
  /// Calls `visit` with id, status and time of the end of every row, in the order of the ids. A
  /// million rows take some tenths of a second.
  void visit_ends(
      const std::function<void(std::string_view, std::string_view, std::string_view)>& visit) const;
  std::optional<Record> find(const std::string& id) const;
  std::vector<Record> beginning_with(const std::string& id) const;
  std::size_t count() const;
  /// All rows (of one study, if named), in the order of their ids.
  std::vector<Record> all(const std::string& study = "") const;

  /// Adds the rows of another store. Rows that both have stay; failed ones are replaced by others.
  void merge(const std::string& other);
  const std::string& path() const { return database_.path(); }

 private:
  explicit Store(Database database) : database_(std::move(database)) {}
  std::int64_t number(const char* sql) const;  ///< the one number that a query gives
  void require_version() const;
  mutable Database database_;
};

}  // namespace porowave::verification
