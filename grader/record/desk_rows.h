// STAFF ONLY. What people did with the desk's items (grader/review/items.h): who accepted an item and what it
// looked like, whose it is, and who has it open.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "grader/record/record.h"

namespace grader::inline record {

struct RowOfItem {
  std::string what;    // is the item's kind and place: "near-threshold H2"
  std::string person;  // is the name of a row; "": the item is of several people

  bool operator<(const RowOfItem& other) const {
    return std::tie(what, person) < std::tie(other.what, other.person);
  }
};

struct DeskRow {
  std::string looks = {}, who = {},
              at = {};       // when it was accepted; `who` "": nobody decided, and these looks are known
  std::string owner = {};    // "": nobody's
  std::string open_by = {};  // had it open last
  std::int64_t open_at = 0;  // is in seconds since 1970
};

// Each change is one transaction, or a part of that of Record::in_one.
class DeskRows {
 public:
  explicit DeskRows(Record& record) : record_(record) {}

  // Returns another value if anything in the record has changed.
  std::pair<std::int64_t, std::int64_t> state();
  std::map<RowOfItem, DeskRow> all();
  // Returns another number for a name if its result or a decision about it has changed.
  std::map<std::string, std::int64_t> versions();

  // Stores that the record's user accepts it, and adds that to the log of its people, with `detail`. Looks
  // "": that nobody has accepted it.
  void accept(const RowOfItem& row, const std::string& looks, const std::vector<std::string>& people,
              const std::string& detail);
  void know(const std::map<RowOfItem, std::string>& looks) { set("looks", looks); }
  void give(const std::map<RowOfItem, std::string>& owners) { set("owner", owners); }
  // Says that the record's user has it open, and no other item.
  void open(const std::optional<RowOfItem>& row, std::int64_t now);

 private:
  std::int64_t id_of(const RowOfItem& row);  // makes it
  void set(const std::string& column, const std::map<RowOfItem, std::string>& texts);

  Record& record_;
};

}  // namespace grader::record
