// STAFF ONLY. Opens and queries the file of a record.
#include "grader/record/database.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sqlite3.h>
#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "grader/course/input.h"
#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline record {
namespace {

constexpr int kPatienceInMs = 60'000;  // others hold the file while they write one result

void bind(sqlite3_stmt* statement, int place, const Value& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value))
    sqlite3_bind_int64(statement, place, *number);
  else if (const auto* real = std::get_if<double>(&value))
    sqlite3_bind_double(statement, place, *real);
  else if (const auto* text = std::get_if<std::string_view>(&value))
    sqlite3_bind_text64(statement, place, text->data() ? text->data() : "", text->size(), SQLITE_STATIC,
                        SQLITE_UTF8);
  else if (const auto* blob = std::get_if<Blob>(&value))
    sqlite3_bind_blob64(statement, place, blob->bytes.data(), blob->bytes.size(), SQLITE_STATIC);
}

struct Finalize {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

struct DeleteSession {
  void operator()(sqlite3_session* session) const { sqlite3session_delete(session); }
};

// SQLite gives its log the mode of the database. It would make the database itself readable for others.
void make_private(const std::filesystem::path& file) {
  Descriptor made(open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
  if (!made && errno != EEXIST)
    throw BadInput(printable(file.string(), 4096) +
                   ": can't be made: " + std::generic_category().message(errno));
}

}  // namespace

bool is_local_file_system(std::uint64_t kind) {
  constexpr std::uint64_t kXfs = 0x58465342, kZfs = 0x2fc12fc1, kRam = 0x858458f6;
  constexpr std::array<std::uint64_t, 8> local{EXT4_SUPER_MAGIC,      kXfs, BTRFS_SUPER_MAGIC, TMPFS_MAGIC,
                                               OVERLAYFS_SUPER_MAGIC, kZfs, F2FS_SUPER_MAGIC,  kRam};
  return std::ranges::find(local, kind) != local.end();
}

std::string DatabaseRow::text(int column) const {
  const void* bytes = sqlite3_column_blob(statement_, column);
  return {static_cast<const char*>(bytes ? bytes : ""),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

std::int64_t DatabaseRow::number(int column) const {
  return sqlite3_column_int64(statement_, column);
}

double DatabaseRow::real(int column) const {
  return sqlite3_column_double(statement_, column);
}

bool DatabaseRow::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

void Database::Close::operator()(sqlite3* connection) const {
  sqlite3_close(connection);
}

Database::Database(std::filesystem::path file, Journal journal) : file_(std::move(file)) {
  make_private(file_);
  sqlite3* connection = nullptr;
  const int code =
      sqlite3_open_v2(file_.c_str(), &connection, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOFOLLOW, nullptr);
  connection_.reset(connection);
  if (code != SQLITE_OK) fail(code);
  sqlite3_extended_result_codes(connection, 1);
  sqlite3_busy_timeout(connection, kPatienceInMs);
  choose_journal(journal);
  run_all(
      "PRAGMA synchronous = FULL; PRAGMA secure_delete = ON; PRAGMA foreign_keys = ON; PRAGMA trusted_schema "
      "= OFF; PRAGMA temp_store = MEMORY;");
}

// Changing the journal needs the file alone, and SQLite does not wait for that: this tries again.
void Database::choose_journal(Journal journal) {
  struct statfs system = {};
  const bool local =
      statfs(file_.c_str(), &system) == 0 && is_local_file_system(static_cast<std::uint64_t>(system.f_type));
  const std::string wanted = local && journal == Journal::best ? "wal" : "delete";
  // A record that was moved from a local disk has a log that can't be read with shared memory here.
  if (wanted == "delete") run_all("PRAGMA locking_mode = EXCLUSIVE;");
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatienceInMs);
  for (;;) {
    try {
      std::string answer = text("PRAGMA journal_mode");
      if (answer != wanted) answer = text("PRAGMA journal_mode = " + wanted);
      if (answer == "wal" || answer == "delete") break;  // a file system may refuse a log
      throw BadInput(file_.string() + ": its journal is \"" + answer + "\", not a file");
    } catch (const BadInput&) {
      const int code = sqlite3_errcode(connection_.get()) & 0xff;
      if ((code != SQLITE_BUSY && code != SQLITE_LOCKED) || std::chrono::steady_clock::now() > end) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  if (wanted == "delete") run_all("PRAGMA locking_mode = NORMAL; SELECT count(*) FROM sqlite_master;");
}

void Database::fail(int code) const {
  const std::string where = printable(file_.string(), 4096) + ": ";
  switch (code & 0xff) {
    case SQLITE_BUSY:
      throw BadInput(where + "another program holds it; end that one, and try again");
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      throw BadInput(where +
                     "is damaged; take a backup of it, or move the folder away and grade the class again");
    case SQLITE_FULL:
      throw BadInput(where + "the disk is full; all that was told as done is kept");
    default:
      throw BadInput(where + (connection_ ? sqlite3_errmsg(connection_.get()) : sqlite3_errstr(code)));
  }
}

void Database::each(std::string_view sql, std::initializer_list<Value> values,
                    const std::function<void(const DatabaseRow&)>& take) {
  const std::lock_guard turn(one_at_a_time_);
  sqlite3_stmt* made = nullptr;
  int code = sqlite3_prepare_v2(connection_.get(), sql.data(), static_cast<int>(sql.size()), &made, nullptr);
  const std::unique_ptr<sqlite3_stmt, Finalize> statement(made);
  if (code != SQLITE_OK) fail(code);
  int place = 0;
  for (const Value& value : values) bind(made, ++place, value);
  while ((code = sqlite3_step(made)) == SQLITE_ROW) take(DatabaseRow(made));
  if (code != SQLITE_DONE) fail(code);
}

void Database::run(std::string_view sql, std::initializer_list<Value> values) {
  each(sql, values, [](const DatabaseRow&) {});
}

void Database::run_all(const std::string& sql) {
  const std::lock_guard turn(one_at_a_time_);
  const int code = sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

std::int64_t Database::number(std::string_view sql, std::initializer_list<Value> values) {
  std::int64_t found = 0;
  each(sql, values, [&](const DatabaseRow& row) { found = row.number(0); });
  return found;
}

std::string Database::text(std::string_view sql, std::initializer_list<Value> values) {
  std::string found;
  each(sql, values, [&](const DatabaseRow& row) { found = row.text(0); });
  return found;
}

bool Database::shred() {
  run("VACUUM");
  return number("PRAGMA wal_checkpoint(TRUNCATE)") == 0;
}

std::pair<std::int64_t, std::int64_t> Database::changes() {
  const std::lock_guard turn(one_at_a_time_);
  return {number("PRAGMA data_version"), sqlite3_total_changes64(connection_.get())};
}

std::string Database::changes_of(const std::function<void()>& changes) {
  sqlite3_session* made = nullptr;
  if (const int code = sqlite3session_create(connection_.get(), "main", &made); code != SQLITE_OK) fail(code);
  const std::unique_ptr<sqlite3_session, DeleteSession> session(made);
  sqlite3session_table_filter(
      made, [](void*, const char* table) { return static_cast<int>(std::string_view(table) != "log"); },
      nullptr);
  if (const int code = sqlite3session_attach(made, nullptr); code != SQLITE_OK) fail(code);
  changes();
  int size = 0;
  void* bytes = nullptr;
  if (const int code = sqlite3session_changeset(made, &size, &bytes); code != SQLITE_OK) fail(code);
  const std::unique_ptr<void, decltype(&sqlite3_free)> owner(bytes, &sqlite3_free);
  return {static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

bool Database::take_back(const std::string& changes) {
  int size = 0;
  void* bytes = nullptr;
  int code = sqlite3changeset_invert(static_cast<int>(changes.size()), changes.data(), &size, &bytes);
  if (code != SQLITE_OK) fail(code);
  const std::unique_ptr<void, decltype(&sqlite3_free)> owner(bytes, &sqlite3_free);
  bool is_used = false;
  const auto apply = [&](int (*takes_table)(void*, const char*)) {
    return sqlite3changeset_apply(
        connection_.get(), size, bytes, takes_table,
        [](void* used, int conflict, sqlite3_changeset_iter*) -> int {
          *static_cast<bool*>(used) = conflict == SQLITE_CHANGESET_FOREIGN_KEY;
          return SQLITE_CHANGESET_ABORT;
        },
        &is_used);
  };
  code = apply(nullptr);
  // A comment that came with these changes stays if others use it by now.
  if (is_used)
    code = apply(
        [](void*, const char* table) { return static_cast<int>(std::string_view(table) != "comments"); });
  if (code != SQLITE_OK && (code & 0xff) != SQLITE_ABORT) fail(code);
  return code == SQLITE_OK;
}

Transaction::Transaction(Database& database, Kind kind)
    : database_(database),
      turn_(database.one_at_a_time_),
      open_(sqlite3_get_autocommit(database.connection_.get()) != 0) {
  if (open_) database_.run(kind == reads ? "BEGIN" : "BEGIN IMMEDIATE");
}

void Transaction::commit() {
  if (open_) database_.run("COMMIT");
  open_ = false;
}

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const BadInput&) {  // SQLite has rolled back already, as on a full disk
  }
}

}  // namespace grader::record
