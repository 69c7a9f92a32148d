// STAFF ONLY. A small interface of SQLite: a file that several processes may use at once, and statements with
// values.
//
// On a local file system the journal is a write-ahead log, else a rollback journal: write-ahead logs need
// shared memory, which network file systems lack; some of them damaged databases silently.
//
// Threads take turns: a statement is a turn, and so is all of a transaction.
//
// The process must never open and close the database's file by other means: that drops SQLite's locks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

struct sqlite3;
struct sqlite3_stmt;

namespace grader::inline record {

enum class Journal { best, rollback };  // best: a write-ahead log if the file system is known to allow it

// Returns true if a file system with this f_type (statfs) has shared memory for all its users. Unknown ones
// count as remote.
bool is_local_file_system(std::uint64_t kind);

struct Blob {
  std::string_view bytes;
};
using Value = std::variant<std::nullptr_t, std::int64_t, double, std::string_view, Blob>;

// This is a row of an answer, valid until the next one.
class DatabaseRow {
 public:
  explicit DatabaseRow(sqlite3_stmt* statement) : statement_(statement) {}

  std::string text(int column) const;  // also bytes; "" for null
  std::int64_t number(int column) const;
  double real(int column) const;
  bool is_null(int column) const;

 private:
  sqlite3_stmt* statement_;
};

class Database {
 public:
  // Makes the file if it is missing; nobody else can read it. All errors are BadInput, a line that names the
  // file.
  explicit Database(std::filesystem::path file, Journal journal = Journal::best);

  void run(std::string_view sql, std::initializer_list<Value> values = {});
  void run_all(const std::string& sql);  // several statements
  void each(std::string_view sql, std::initializer_list<Value> values,
            const std::function<void(const DatabaseRow&)>& take);
  std::int64_t number(std::string_view sql, std::initializer_list<Value> values = {});  // 0 without a row
  std::string text(std::string_view sql, std::initializer_list<Value> values = {});     // "" without a row

  // Removes all bytes of deleted rows from file and journal. False if a reader held the log meanwhile.
  bool shred();

  // Counts changes of others and own ones: the same number means that nothing has changed.
  std::pair<std::int64_t, std::int64_t> changes();

  // Runs `changes`, and returns what they changed in all tables but the log, for take_back.
  std::string changes_of(const std::function<void()>& changes);
  // Takes these changes back. False if a row is not any more as they left it: then nothing is changed.
  bool take_back(const std::string& changes);

  const std::filesystem::path& file() const { return file_; }

 private:
  friend class Transaction;
  struct Close {
    void operator()(sqlite3* connection) const;
  };

  void choose_journal(Journal journal);
  [[noreturn]] void fail(int code) const;

  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> connection_;
  std::recursive_mutex one_at_a_time_;
};

// Does all or nothing: without commit() all of it is undone. One that writes has the right to it from its
// begin on. One inside another is a part of that one.
class Transaction {
 public:
  enum Kind { writes, reads };  // reads: sees one state of the file, and needs no commit
  explicit Transaction(Database& database, Kind kind = writes);
  Transaction(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  Database& database_;
  const std::lock_guard<std::recursive_mutex> turn_;
  bool open_;
};

}  // namespace grader::record
