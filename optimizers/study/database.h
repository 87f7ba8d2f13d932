// An SQLite database that survives its writer.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace delos {

/// A statement while it is run. Parameters count from 1, columns from 0.
class Statement {
 public:
  Statement(sqlite3* database, const char* sql);

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, const std::string& text);
  Statement& bind(int parameter, std::span<const double> numbers);

  /// @returns whether there is a row
  /// @throws std::runtime_error what SQLite says: the disk is full, …
  bool step();

  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;  ///< NaN where there is none
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::vector<double> numbers(int column) const;

 private:
  void check(int result) const;
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
};

/// An open database file. Every statement is a transaction of its own, written to the
/// system before it returns: a killed process loses nothing that it was told is there.
class Database {
 public:
  /// What can't be written, or is in a folder that can't, is opened for reading.
  /// @param create make it; it is written in one go then, without a log beside it
  /// @throws std::runtime_error it can't be opened or made
  Database(const std::filesystem::path& file, bool create);

  /// @throws std::runtime_error pages of the file are missing or damaged
  /// @cost reads all of it
  void check_whole() const;

  [[nodiscard]] Statement prepare(const char* sql) const;
  /// Run statements that give no rows.
  void run(const char* sql) const;

 private:
  std::filesystem::path file_;
  bool had_log_;  ///< beside it, when it was opened
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_;
};

/// Give a file that was made under another name its own.
/// @returns whether there was none of that name; else the made one is removed
/// @throws std::runtime_error it can't be renamed
[[nodiscard]] bool publish(const std::filesystem::path& made,
                           const std::filesystem::path& file);

}  // namespace delos
