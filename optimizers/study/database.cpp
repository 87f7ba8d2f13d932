#include "study/database.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace delos {
namespace {

constexpr const char* kReadOnly = ": can't be written; copy it to where it can";

/// Whether a log can be written beside it.
bool is_writable(const std::filesystem::path& file) {
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  return access(file.c_str(), W_OK) == 0 && access(folder.c_str(), W_OK) == 0;
}

/// For a file that nobody changes: without locks, and without an index of its log,
/// which would have to be written.
std::string unchanging(const std::filesystem::path& file) {
  std::string uri = "file://";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '%' || c == '?' || c == '#') {
      char code[4];
      std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(c));
      uri += code;
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

}  // namespace

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
  if (result == SQLITE_READONLY)
    sentence = std::string(file ? file : "study") + kReadOnly;
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
    : file_(file),
      had_log_(std::filesystem::exists(file.string() + "-wal")),
      database_(nullptr, &sqlite3_close) {
  sqlite3* raw = nullptr;
  const bool reads_only = !create && !is_writable(file);
  // SQLite opens for reading alone what it can't write.
  const int flags =
      SQLITE_OPEN_READWRITE | SQLITE_OPEN_URI | (create ? SQLITE_OPEN_CREATE : 0);
  // Somebody else may be writing where there is a log.
  const std::string name = reads_only && !had_log_
                               ? unchanging(file)
                               : std::filesystem::absolute(file).string();
  const int result = sqlite3_open_v2(name.c_str(), &raw, flags, nullptr);
  database_.reset(raw);
  if (result != SQLITE_OK)
    throw std::runtime_error(file.string() + ": " + sqlite3_errmsg(raw));
  sqlite3_busy_timeout(raw, 10000);
  if (create || reads_only) return;
  // A write-ahead log: readers don't wait for the search, and a killed writer leaves
  // whole transactions only.
  run("PRAGMA journal_mode = WAL");
  run("PRAGMA synchronous = NORMAL");
}

void Database::check_whole() const {
  const auto damaged = [&](const std::string& how) {
    return std::runtime_error(file_.string() +
                              ": the file is damaged or cut short: " + how);
  };
  Statement check = prepare("PRAGMA quick_check(1)");
  check.step();
  const std::string found = check.text(0);
  // The first line of several only says which database.
  if (found != "ok") throw damaged(found.substr(found.find('\n') + 1));
  // Ends of pages may be data that nothing tells from others. Where there was a log, it
  // has what is missing.
  Statement page = prepare("PRAGMA page_size");
  page.step();
  if (!had_log_ &&
      std::filesystem::file_size(file_) % static_cast<std::uintmax_t>(page.integer(0)))
    throw damaged("its last page isn't whole");
}

bool publish(const std::filesystem::path& made, const std::filesystem::path& file) {
  int failure =
      renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, file.c_str(), RENAME_NOREPLACE) == 0
          ? 0
          : errno;
  // Not every file system can tell.
  if (failure == EINVAL || failure == ENOSYS) {
    failure = std::filesystem::exists(file)                  ? EEXIST
              : std::rename(made.c_str(), file.c_str()) == 0 ? 0
                                                             : errno;
  }
  if (failure == 0) return true;
  std::error_code ignored;
  std::filesystem::remove(made, ignored);
  if (failure == EEXIST) return false;
  throw std::runtime_error(file.string() + ": " +
                           std::generic_category().message(failure));
}

Statement Database::prepare(const char* sql) const { return {database_.get(), sql}; }

void Database::run(const char* sql) const {
  char* message = nullptr;
  const int result = sqlite3_exec(database_.get(), sql, nullptr, nullptr, &message);
  if (result == SQLITE_OK) return;
  const std::string what = message ? message : "unknown error";
  sqlite3_free(message);
  if ((result & 0xff) == SQLITE_READONLY)
    throw std::runtime_error(file_.string() + kReadOnly);
  throw std::runtime_error(file_.string() + ": " + what);
}

}  // namespace delos
