// STAFF ONLY. A submission while it is read, and what it has used of its limits.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "grader/intake/archive.h"
#include "grader/intake/container.h"
#include "grader/intake/exercise_names.h"
#include "grader/intake/submission.h"

namespace grader::inline intake {

class IntakeBudget {
 public:
  explicit IntakeBudget(const IntakeLimits& limits) : limits_(limits), bytes_left_(limits.unpacked_bytes) {}

  // So many more files and folders. Throws Refused, as the next one.
  void charge_entries(std::size_t count);
  // Counts entries that will be read. Sizes are those that the container states; reading is limited again by
  // what really comes.
  void charge_bytes(std::uintmax_t bytes);

  ArchiveLimits for_archive() const { return {limits_.stream_bytes, limits_.entries}; }

 private:
  IntakeLimits limits_;
  std::size_t bytes_left_;
  std::size_t entries_ = 0;
};

// An exercise file as a submission has it.
struct Found {
  std::string shown;       // where it lies
  bool set_aside = false;  // among builds or backups (same_name.h)
  bool renamed = false;    // under a name that copies get

  std::pair<bool, bool> rank() const { return {set_aside, renamed}; }
};

// The one that is taken of all files of one name.
struct Choice {
  Found taken;
  std::string rival = {};  // counts as much, and has other bytes
};

// Files of one name that a rule passed over.
struct PassedOver {
  std::string first;
  std::size_t count = 0;
};

struct Draft {
  Submission submission;
  std::string origin;  // for staff: which argument, and where in it
  std::string path;    // the same from the root of the disk on, whatever the argument was
  std::string shown;   // for students: its own part of the path, with the folder or archive around it
  IntakeBudget budget;
  std::map<std::string, Choice> found = {};  // by exercise file
  std::map<std::string, PassedOver> passed_over = {};
  std::size_t archives = 0;                      // opened in it
  std::vector<std::string> seen = {};            // names of other files in it, the first ones
  std::map<std::string, std::string> near = {};  // by exercise file: a file that looks like it
  std::vector<std::string> shut = {};  // archives in it that can't be read: sentences for the student
  std::vector<std::string> notices = {}, remarks = {};  // for staff: to look at, to know
  std::vector<Accounted> accounted = {};

  void refuse(const Refused& why);
  bool refused() const { return !submission.problem.empty(); }

  // A file was read, or can't be. Of files of one name the one of the least rank is taken; identical bytes
  // count once.
  void offer(const std::string& exercise_file, const Found& where, SourceFile file);
  void pass_over(const std::string& exercise_file, const std::string& where, std::size_t count = 1);
  void see(std::string_view name);

  // Says which files were taken, and what a person must look at; `exercise_files` are all of the course.
  void finish(const FileNames& exercise_files);
};

// Why an entry that should be a file is none, or must not be taken; "" if all is well.
std::string problem_of(const Entry& entry, const std::string& shown);

}  // namespace grader::intake
