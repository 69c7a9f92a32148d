// STAFF ONLY. What people did with the desk's items (grader/review/items.h): who accepted an item and what it
// looked like, whose it is, and who has it open.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "grader/record/points/decisions.h"

namespace grader::inline record {

class Record;

struct RowOfItem {
  std::string what;    // is the item's kind and place: "near H2.3"
  std::string person;  // is the name of a row; "": of several people

  auto operator<=>(const RowOfItem&) const = default;
};

struct DeskRow {
  std::string looks, who, at;  // when it was accepted; "": nobody has
  std::string owner;           // "": nobody's
  std::string open_by;         // had it open last
  std::int64_t open_at = 0;    // are seconds since 1970
};

// Each change is one transaction, and a part of the one of Record::in_one.
class DeskRows {
 public:
  explicit DeskRows(Record& record) : record_(record) {}

  std::map<RowOfItem, DeskRow> all();
  // Stores who accepted it; the log has it. `looks` "": takes that back.
  void accept(const RowOfItem& row, const std::string& looks);
  // Stores looks of several without a log entry: nobody decided.
  void know(const std::map<RowOfItem, std::string>& looks);
  void give(const std::map<RowOfItem, std::string>& owners);
  // Tells others that this one has it open; "" as `who`: not any more.
  void open(const RowOfItem& row, const std::string& who, std::int64_t now);
  // Puts a person's decisions of a place back to what they were.
  void put_back(const std::string& name, const std::vector<Decision>& decisions);

 private:
  Record& record_;
};

}  // namespace grader::record
