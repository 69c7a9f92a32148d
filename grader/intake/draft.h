// STAFF ONLY. A submission while it is read, and what it has used of its limits.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grader/intake/archive.h"
#include "grader/intake/container.h"
#include "grader/intake/submission.h"

namespace grader {

class IntakeBudget {
 public:
  explicit IntakeBudget(const IntakeLimits& limits) : limits_(limits), bytes_left_(limits.unpacked_bytes) {}

  // Sizes are those that the container states; reading is limited again by what really comes. Throws Refused.
  void charge(const std::vector<Entry>& list, const std::vector<std::size_t>& entries);

  ArchiveLimits for_archive() const { return {limits_.unpacked_bytes, limits_.entries}; }

 private:
  IntakeLimits limits_;
  std::size_t bytes_left_;
  std::size_t entries_ = 0;
};

// Entries of a submission that were left out for one reason: the first is named, the others are counted.
struct LeftOut {
  std::string first;
  std::size_t count = 0;

  void add(const std::string& entry_and_reason);
};

struct Draft {
  Submission submission;
  std::string origin;  // for staff: which argument, and where in it
  std::string path;    // the same from the root of the disk on, whatever the argument was
  std::string shown;   // for students: its own part of the path, with the folder or archive around it
  IntakeBudget budget;
  std::map<std::string, std::string> first_paths = {};  // where each exercise file was found first
  std::size_t archives = 0;                             // opened in it
  LeftOut shut = {}, outdated = {};                     // archives that were not opened, older versions
  std::vector<std::string> notices = {};

  void refuse(const Refused& why);
  std::vector<std::string> all_notices() const;
  bool refused() const { return !submission.problem.empty(); }
};

// Why an entry that should be a file is none, or must not be taken; "" if all is well.
std::string problem_of(const Entry& entry, const std::string& shown);

}  // namespace grader
