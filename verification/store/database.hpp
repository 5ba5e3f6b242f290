#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace porowave::verification {

/// A statement of SQL, to be run many times. Parameters and columns count from 0.
class Statement {
 public:
  void bind(int parameter, std::string_view text);
  void bind(int parameter, std::int64_t number);
  void bind(int parameter, double number);  ///< a number that is not finite becomes NULL

  /// True while there is a row. Throws EnvironmentError.
  bool step();
  /// Runs a statement without rows, and makes it ready to be bound again.
  void run();
  void reset();

  std::string text(int column) const;
  std::string_view view(int column) const;  ///< the same, valid until the next step
  std::int64_t integer(int column) const;
  std::optional<double> number(int column) const;  ///< none for NULL

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  sqlite3* database_ = nullptr;
  std::string path_;
};

/// An SQLite file. Failures are EnvironmentError with the file's name (disk full, locked, not
/// writable); a file that is no database is an InputError.
class Database {
 public:
  enum class Mode { read, create };
  Database(const std::string& path, Mode mode);

  void execute(const std::string& sql);
  Statement prepare(const std::string& sql);
  const std::string& path() const { return path_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace porowave::verification
