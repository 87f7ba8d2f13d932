#include "study/database.h"

#include <cstring>
#include <limits>
#include <stdexcept>

namespace delos {

Statement::Statement(sqlite3* database, const char* sql)
    : database_(database), statement_(nullptr, &sqlite3_finalize) {
  sqlite3_stmt* raw = nullptr;
  check(sqlite3_prepare_v2(database, sql, -1, &raw, nullptr));
  statement_.reset(raw);
}

void Statement::check(int result) const {
  if (result == SQLITE_OK || result == SQLITE_ROW || result == SQLITE_DONE) return;
  const std::string what = sqlite3_errmsg(database_);
  const char* file = sqlite3_db_filename(database_, "main");
  std::string sentence = std::string(file ? file : "study") + ": " + what;
  if (result == SQLITE_FULL || result == SQLITE_IOERR)
    sentence += "; what was written before is intact: make room and resume";
  throw std::runtime_error(sentence);
}

Statement& Statement::bind(int parameter, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), parameter, value));
  return *this;
}

Statement& Statement::bind(int parameter, double value) {
  check(sqlite3_bind_double(statement_.get(), parameter, value));
  return *this;
}

Statement& Statement::bind(int parameter, const std::string& text) {
  check(sqlite3_bind_text(statement_.get(), parameter, text.data(),
                          static_cast<int>(text.size()), SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind(int parameter, std::span<const double> numbers) {
  check(sqlite3_bind_blob(statement_.get(), parameter, numbers.data(),
                          static_cast<int>(numbers.size_bytes()), SQLITE_TRANSIENT));
  return *this;
}

bool Statement::step() {
  const int result = sqlite3_step(statement_.get());
  // The low byte is the error, the rest its details.
  check(result == SQLITE_ROW || result == SQLITE_DONE ? result : result & 0xff);
  return result == SQLITE_ROW;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
  if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL)
    return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* bytes =
      reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return bytes ? std::string(bytes, static_cast<std::size_t>(
                                        sqlite3_column_bytes(statement_.get(), column)))
               : std::string();
}

std::vector<double> Statement::numbers(int column) const {
  const auto size =
      static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  std::vector<double> numbers(size / sizeof(double));
  if (!numbers.empty())
    std::memcpy(numbers.data(), sqlite3_column_blob(statement_.get(), column),
                numbers.size() * sizeof(double));
  return numbers;
}

Database::Database(const std::filesystem::path& file, bool create)
    : file_(file), database_(nullptr, &sqlite3_close) {
  sqlite3* raw = nullptr;
  const int flags = SQLITE_OPEN_READWRITE | (create ? SQLITE_OPEN_CREATE : 0);
  const int result = sqlite3_open_v2(file.c_str(), &raw, flags, nullptr);
  database_.reset(raw);
  if (result != SQLITE_OK)
    throw std::runtime_error(file.string() + ": " + sqlite3_errmsg(raw));
  sqlite3_busy_timeout(raw, 10000);
  if (create) return;
  // A write-ahead log: readers don't wait for the search, and a killed writer leaves
  // whole transactions only.
  run("PRAGMA journal_mode = WAL");
  run("PRAGMA synchronous = NORMAL");
}

Statement Database::prepare(const char* sql) const { return {database_.get(), sql}; }

void Database::run(const char* sql) const {
  char* message = nullptr;
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, &message) == SQLITE_OK)
    return;
  const std::string what = message ? message : "unknown error";
  sqlite3_free(message);
  throw std::runtime_error(file_.string() + ": " + what);
}

}  // namespace delos
