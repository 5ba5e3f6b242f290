#include "verification/store/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cmath>
#include <filesystem>

#include "reference/problem/errors.hpp"

namespace porowave::verification {

namespace {

/// Another process may be writing; it never takes long.
constexpr int patience_ms = 60'000;

[[noreturn]] void fail(const std::string& path, sqlite3* database, int code) {
  const char* reason = database ? sqlite3_errmsg(database) : sqlite3_errstr(code);
  if ((code & 0xff) == SQLITE_NOTADB) {
    throw InputError(fmt::format("{}: {}: expected a store of porowave", path, reason));
  }
  const char* expected = "a file that can be written";
  if ((code & 0xff) == SQLITE_FULL) expected = "a disk with space; what was stored is kept";
  if ((code & 0xff) == SQLITE_BUSY) expected = "no other program that keeps the store locked";
  throw EnvironmentError(fmt::format("{}: {}: expected {}", path, reason, expected));
}

/// What a program killed while it wrote has left is taken back, which a database opened only to be
/// read must not do.
void roll_back(const std::string& path) {
  if (!std::filesystem::exists(path + "-journal")) return;
  try {
    Database(path, Database::Mode::create).prepare("SELECT count(*) FROM sqlite_master").step();
  } catch (const EnvironmentError&) {
    // Not ours to write: reading says what is wrong, if anything is.
  }
}

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close(database);
}

void Statement::bind(int parameter, std::string_view text) {
  sqlite3_bind_text64(statement_.get(), parameter + 1, text.data(), text.size(), SQLITE_TRANSIENT,
                      SQLITE_UTF8);
}

void Statement::bind(int parameter, std::int64_t number) {
  sqlite3_bind_int64(statement_.get(), parameter + 1, number);
}

void Statement::bind(int parameter, double number) {
  if (std::isfinite(number)) {
    sqlite3_bind_double(statement_.get(), parameter + 1, number);
  } else {
    sqlite3_bind_null(statement_.get(), parameter + 1);
  }
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  fail(path_, database_, code);
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

void Statement::reset() {
  sqlite3_reset(statement_.get());
}

std::string Statement::text(int column) const {
  return std::string(view(column));
}

std::string_view Statement::view(int column) const {
  const auto* data = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return data ? std::string_view(data, static_cast<std::size_t>(size)) : std::string_view();
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::optional<double> Statement::number(int column) const {
  if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL) return std::nullopt;
  return sqlite3_column_double(statement_.get(), column);
}

Database::Database(const std::string& path, Mode mode) : path_(path) {
  if (std::filesystem::is_directory(path)) {
    throw InputError(path + ": is a directory: expected a store of porowave");
  }
  if (mode == Mode::read && !std::filesystem::exists(path)) {
    throw InputError(path + ": cannot be read: expected a store of porowave");
  }
  if (mode == Mode::read) roll_back(path);
  sqlite3* opened = nullptr;
  // SQLite has names that are no files, such as ":memory:"; a path with a folder is none of them.
  const std::string file = std::filesystem::path(path).is_absolute() ? path : "./" + path;
  // WAL needs its index even to read, so reading asks for no less than writing where it may.
  const int flags =
      mode == Mode::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  const int code = sqlite3_open_v2(file.c_str(), &opened, flags, nullptr);
  database_.reset(opened);
  if (code != SQLITE_OK) fail(path_, opened, code);
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_busy_timeout(opened, patience_ms);
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(path_, database_.get(), code);
}

Statement Database::prepare(const std::string& sql) {
  sqlite3_stmt* prepared = nullptr;
  const int code = sqlite3_prepare_v2(database_.get(), sql.c_str(), static_cast<int>(sql.size()),
                                      &prepared, nullptr);
  if (code != SQLITE_OK) fail(path_, database_.get(), code);
  Statement statement;
  statement.statement_.reset(prepared);
  statement.database_ = database_.get();
  statement.path_ = path_;
  return statement;
}

}  // namespace porowave::verification
