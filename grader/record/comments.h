// STAFF ONLY. Comments, which several people of a hand-in may have, and requests for another look.
//
// A comment is put at a place by Record::decide (with `why` and `number`, or with `comment`, the id of an
// earlier one), and taken back by Record::undo. An equal one that is there already is used again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace grader::inline record {

struct CommentUse {
  std::string name, place;  // "H2", "H2.3", "H2:17", or "" for the whole
  std::string code;         // is the line of "H2:17"
  std::string who, at;      // put it there
};

struct Comment {
  std::int64_t id = 0;
  std::string text;
  double points = 0;  // are given at each of its places, or below 0 taken; 0: it only says something
  std::vector<CommentUse> uses = {};
};

// Says "ada H2.3, ben H2:17", for staff.
std::string who_have(const Comment& comment);

struct Request {
  std::int64_t id = 0;
  std::string name, place, code, text;
  std::string who, at;                        // entered it
  std::string answer, answered_by, answered;  // "": it is open

  bool is_open() const { return answered.empty(); }
};

}  // namespace grader::record
