#include "verification/store/store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "reference/problem/errors.hpp"
#include "verification/not_a_number.hpp"

namespace porowave::verification {

namespace {

/// Of the tables; stores of another version are refused.
constexpr std::int64_t version = 1;
constexpr std::int64_t application = 0x706f726f;  // "poro"

const std::vector<std::string>& columns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list = {"id",     "study", "specification", "status",
                                     "reason", "steps", "time_step",     "points"};
    list.insert(list.end(), measure_names().begin(), measure_names().end());
    list.insert(list.end(), {"cpu_seconds", "wall_seconds", "peak_rss_bytes", "calibration_ns",
                             "finished", "provenance"});
    return list;
  }();
  return names;
}

/// Rows in the order in which they come, with an index of their ids: a row is longer than a quarter
/// of a page, and what is longer than that would fill pages of its own in the tree of the ids.
std::string table_sql() {
  std::vector<std::string> measures;
  for (const std::string& name : measure_names()) measures.push_back(name + " REAL");
  return fmt::format(
      "CREATE TABLE IF NOT EXISTS cases (id TEXT PRIMARY KEY NOT NULL, study TEXT NOT NULL, "
      "specification TEXT NOT NULL, status TEXT NOT NULL, reason TEXT NOT NULL, "
      "steps INTEGER NOT NULL, time_step REAL, points INTEGER NOT NULL, {}, cpu_seconds REAL, "
      "wall_seconds REAL, peak_rss_bytes INTEGER, calibration_ns REAL, finished TEXT NOT NULL, "
      "provenance TEXT NOT NULL);"
      "CREATE TABLE IF NOT EXISTS provenance (id TEXT PRIMARY KEY, version TEXT, git TEXT, "
      "numerics TEXT, compiler TEXT, flags TEXT, cpu TEXT, host TEXT) WITHOUT ROWID;"
      // All that a status needs: the rows themselves are twenty times as long.
      "CREATE INDEX IF NOT EXISTS ends ON cases (id, status, finished);",
      fmt::join(measures, ", "));
}

/// The name of a column as SQL takes it, whatever it is.
std::string quoted_name(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) text.append(c == '"' ? 2 : 1, c);
  return text + "\"";
}

/// What happens to a row that is there already.
constexpr auto unless_failed = " ON CONFLICT(id) DO UPDATE SET {} WHERE cases.status = 'failed'";

std::string replacement(const std::vector<std::string>& names) {
  std::vector<std::string> assignments;
  for (const std::string& name : names) {
    if (name != "id") assignments.push_back(fmt::format("{0} = excluded.{0}", quoted_name(name)));
  }
  return fmt::format(fmt::runtime(unless_failed), fmt::join(assignments, ", "));
}

std::string insert_sql() {
  const std::vector<std::string> marks(columns().size(), "?");
  return fmt::format("INSERT INTO cases ({}) VALUES ({}){}", fmt::join(columns(), ", "),
                     fmt::join(marks, ", "), replacement(columns()));
}

/// Names of the columns of the table `cases` of a schema, "main" or that of an attached database.
std::vector<std::string> columns_in(Database& database, const std::string& schema) {
  Statement rows = database.prepare("SELECT name FROM pragma_table_info('cases', ?)");
  rows.bind(0, schema);
  std::vector<std::string> names;
  while (rows.step()) names.push_back(rows.text(0));
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Adds columns for measures; within a transaction of the caller.
void add_columns(Database& database, const std::vector<std::string>& names) {
  const std::vector<std::string> present = columns_in(database, "main");
  for (const std::string& name : names) {
    if (contains(present, name)) continue;
    database.execute(fmt::format("ALTER TABLE main.cases ADD COLUMN {} REAL", quoted_name(name)));
  }
}

/// All or nothing of what is done while it lives; nothing unless it is committed.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) {
    database_.execute("BEGIN IMMEDIATE");
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction() {
    if (!open_) return;
    // A full disk has rolled back by itself; then this finds nothing to do.
    try {
      database_.execute("ROLLBACK");
    } catch (const EnvironmentError&) {
    }
  }
  void commit() {
    database_.execute("COMMIT");
    open_ = false;
  }

 private:
  Database& database_;
  bool open_ = true;
};

/// A column that the store does not have is NULL in every row.
std::string select_sql(Database& database, const std::string& condition) {
  const std::vector<std::string> present = columns_in(database, "main");
  std::vector<std::string> wanted = columns();
  for (std::string& name : wanted) {
    if (!contains(present, name)) name = "NULL";
  }
  return fmt::format("SELECT {} FROM cases{} ORDER BY id", fmt::join(wanted, ", "), condition);
}

void bind(Statement& statement, const Record& record) {
  int i = 0;
  statement.bind(i++, record.id);
  statement.bind(i++, record.study);
  statement.bind(i++, record.specification);
  statement.bind(i++, case_status_names[static_cast<std::size_t>(record.status)]);
  statement.bind(i++, record.reason);
  statement.bind(i++, record.steps);
  statement.bind(i++, record.time_step);
  statement.bind(i++, record.points);
  for (std::size_t m = 0; m < measure_names().size(); ++m) {
    statement.bind(i++, m < record.measures.size() ? record.measures[m]
                                                   : std::numeric_limits<double>::quiet_NaN());
  }
  statement.bind(i++, record.cpu_seconds);
  statement.bind(i++, record.wall_seconds);
  statement.bind(i++, record.peak_rss_bytes);
  statement.bind(i++, record.calibration_ns);
  statement.bind(i++, record.finished);
  statement.bind(i++, record.provenance);
}

Record record_of(const Statement& row) {
  int i = 0;
  Record record;
  record.id = row.text(i++);
  record.study = row.text(i++);
  record.specification = row.text(i++);
  const std::string status = row.text(i++);
  const auto* const found =
      std::find(case_status_names.begin(), case_status_names.end(), std::string_view(status));
  record.status = found == case_status_names.end()
                      ? CaseStatus::failed
                      : static_cast<CaseStatus>(found - case_status_names.begin());
  record.reason = row.text(i++);
  record.steps = row.integer(i++);
  record.time_step = row.number(i++).value_or(nan);
  record.points = row.integer(i++);
  for (std::size_t m = 0; m < measure_names().size(); ++m) {
    record.measures.push_back(row.number(i++).value_or(nan));
  }
  record.cpu_seconds = row.number(i++).value_or(nan);
  record.wall_seconds = row.number(i++).value_or(nan);
  record.peak_rss_bytes = row.integer(i++);
  record.calibration_ns = row.number(i++).value_or(nan);
  record.finished = row.text(i++);
  record.provenance = row.text(i++);
  return record;
}

}  // namespace

Store Store::create_or_open(const std::string& path, Journal journal) {
  Store store(Database(path, Database::Mode::create));
  // A program killed while it made its store has left a database without anything in it.
  const bool fresh = store.number("PRAGMA application_id") == 0 &&
                     store.number("SELECT count(*) FROM sqlite_master") == 0;
  if (!fresh) store.require_version();
  if (journal == Journal::write_ahead) {
    store.database_.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
  }
  Transaction transaction(store.database_);
  store.database_.execute(
      table_sql() +
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", application, version));
  add_columns(store.database_, measure_names());
  add_columns(store.database_, {"calibration_ns"});
  transaction.commit();
  return store;
}

Store Store::open(const std::string& path) {
  Store store(Database(path, Database::Mode::read));
  store.require_version();
  return store;
}

std::int64_t Store::number(const char* sql) const {
  Statement statement = database_.prepare(sql);
  statement.step();
  return statement.integer(0);
}

void Store::require_version() const {
  if (number("PRAGMA application_id") != application) {
    throw InputError(path() + ": is a database of another program: expected a store of porowave");
  }
  const auto found = number("PRAGMA user_version");
  if (found != version) {
    throw InputError(
        fmt::format("{}: is a store of version {}: expected version {}", path(), found, version));
  }
}

void Store::add(const std::vector<Record>& records) {
  Statement insert = database_.prepare(insert_sql());
  Transaction transaction(database_);
  try {
    for (const Record& record : records) {
      bind(insert, record);
      insert.run();
    }
    transaction.commit();
  } catch (...) {
    insert.reset();
    throw;
  }
}

void Store::add(const Provenance& provenance) {
  Statement insert =
      database_.prepare("INSERT OR IGNORE INTO provenance VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  int i = 0;
  for (const std::string* text :
       {&provenance.id, &provenance.version, &provenance.git, &provenance.numerics,
        &provenance.compiler, &provenance.flags, &provenance.cpu, &provenance.host}) {
    insert.bind(i++, *text);
  }
  insert.run();
}

std::set<std::string> Store::finished_ids() const {
  Statement rows = database_.prepare("SELECT id FROM cases WHERE status <> 'failed'");
  std::set<std::string> ids;
  while (rows.step()) ids.insert(rows.text(0));
  return ids;
}

void Store::visit_ends(
    const std::function<void(std::string_view, std::string_view, std::string_view)>& visit) const {
  Statement rows = database_.prepare("SELECT id, status, finished FROM cases ORDER BY id");
  while (rows.step()) visit(rows.view(0), rows.view(1), rows.view(2));
}

bool Store::finished(const std::string& id) const {
  Statement rows = database_.prepare("SELECT 1 FROM cases WHERE id = ? AND status <> 'failed'");
  rows.bind(0, id);
  return rows.step();
}

std::optional<Record> Store::find(const std::string& id) const {
  Statement rows = database_.prepare(select_sql(database_, " WHERE id = ?"));
  rows.bind(0, id);
  if (!rows.step()) return std::nullopt;
  return record_of(rows);
}

std::vector<Record> Store::beginning_with(const std::string& id) const {
  Statement rows = database_.prepare(select_sql(database_, " WHERE substr(id, 1, ?) = ?"));
  rows.bind(0, static_cast<std::int64_t>(id.size()));
  rows.bind(1, id);
  std::vector<Record> records;
  while (rows.step()) records.push_back(record_of(rows));
  return records;
}

std::size_t Store::count() const {
  Statement rows = database_.prepare("SELECT count(*) FROM cases");
  rows.step();
  return static_cast<std::size_t>(rows.integer(0));
}

std::vector<Record> Store::all(const std::string& study) const {
  Statement rows =
      database_.prepare(select_sql(database_, study.empty() ? "" : " WHERE study = ?"));
  if (!study.empty()) rows.bind(0, study);
  std::vector<Record> records;
  while (rows.step()) records.push_back(record_of(rows));
  return records;
}

void Store::merge(const std::string& other) {
  open(other);  // refuses what is no store
  Statement attach = database_.prepare("ATTACH DATABASE ? AS other");
  attach.bind(0, other);
  attach.run();
  const std::vector<std::string> names = columns_in(database_, "other");
  Transaction transaction(database_);
  add_columns(database_, names);
  std::vector<std::string> list(names.size());
  std::transform(names.begin(), names.end(), list.begin(), quoted_name);
  // "WHERE true" lets SQLite tell the conflict clause from a join.
  database_.execute(
      fmt::format("INSERT OR IGNORE INTO provenance SELECT * FROM other.provenance; "
                  "INSERT INTO cases ({0}) SELECT {0} FROM other.cases WHERE true{1}",
                  fmt::join(list, ", "), replacement(names)));
  transaction.commit();
  database_.execute("DETACH DATABASE other");
}

}  // namespace porowave::verification
