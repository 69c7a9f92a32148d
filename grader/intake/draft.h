// STAFF ONLY. A submission while it is read, and the used part of its limits.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "grader/intake/archives/archive.h"
#include "grader/intake/archives/container.h"
#include "grader/intake/names/exercise_names.h"
#include "grader/intake/submission.h"

namespace grader::inline intake {

class IntakeBudget {
 public:
  explicit IntakeBudget(const IntakeLimits& limits) : limits_(limits), bytes_left_(limits.unpacked_bytes) {}

  // Counts more files and folders. Throws Refused, as charge_bytes does.
  void charge_entries(std::size_t count);
  // Counts entries that will be read, by the sizes that the container states; reading is limited again by the
  // real sizes.
  void charge_bytes(std::uintmax_t bytes);

  ArchiveLimits for_archive() const { return {limits_.stream_bytes, limits_.entries}; }

 private:
  IntakeLimits limits_;
  std::size_t bytes_left_;
  std::size_t entries_ = 0;
};

// Holds the place of an exercise file in a submission.
struct Found {
  std::string shown;       // is the path for people
  bool set_aside = false;  // lies among builds or backups (same_name.h)
  bool renamed = false;    // has a name that copies get

  std::pair<bool, bool> rank() const { return {set_aside, renamed}; }
};

// Holds the chosen one of all files with one name.
struct Choice {
  Found taken;
  std::string rival = {};  // has the same rank, but other bytes
};

// Lists files of one name that a rule rejected.
struct PassedOver {
  std::string first;
  std::size_t count = 0;
};

struct Draft {
  Submission submission;
  std::string origin;  // names the argument and the place in it, for staff
  std::string path;    // is the same path from the disk's root on, whatever the argument was
  std::string shown;   // is the student's own part of the path, with the folder or archive around it
  IntakeBudget budget;
  std::map<std::string, Choice> found = {};  // by exercise file
  std::map<std::string, PassedOver> passed_over = {};
  std::size_t archives = 0;                      // counts archives that were opened in it
  std::vector<std::string> seen = {};            // are the first names of other files in it
  std::map<std::string, std::string> near = {};  // by exercise file: a file with a similar name
  std::vector<std::string> shut = {};  // name archives in it that can't be read: sentences for the student
  std::vector<std::string> notices = {}, remarks = {};  // both for staff: only notices need a look
  std::vector<Accounted> accounted = {};

  void refuse(const Refused& why);
  bool refused() const { return !submission.problem.empty(); }

  // Adds a file that was read, or can't be. Of files with one name the lowest rank is taken; identical bytes
  // count once.
  void offer(const std::string& exercise_file, const Found& where, SourceFile file);
  void pass_over(const std::string& exercise_file, const std::string& where, std::size_t count = 1);
  void see(std::string_view name);

  // Reports the taken files, and those that a person must look at; `exercise_files` are all of the course.
  void finish(const FileNames& exercise_files);
};

// Separates submissions that get the same name. Owners whose names differ ("x 1" and "x_1") get names of
// their own. If the owner is the same (x.zip and x.tar.gz), it is unclear which one counts: none is graded;
// all others are, and each has a problem that names another of them, and a notice. An argument keeps its name
// if a member of a class has the same one. Sorts by name, whatever the order was before. Leaves out
// repetitions.
void resolve_clashes(std::vector<Draft>& drafts, std::vector<std::string>& notices);

// Returns why an entry is no regular file, or must not be taken; "" if all is well.
std::string problem_of(const Entry& entry, const std::string& shown);

}  // namespace grader::intake
