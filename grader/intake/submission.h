// STAFF ONLY. Submissions as read_submissions.h gives them, and what reading may take.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grader/course/input.h"
#include "grader/intake/archives/accounted.h"
#include "grader/intake/layouts/system.h"
#include "grader/intake/names/owner.h"

namespace grader::inline intake {

// An origin of a submission: the argument itself, or the class that held it. In a folder of grades no
// submission is replaced by one of another origin unless a person says so: the content of a hand-in must not
// reach other students' results.
//
// "hand-in /home/ta/alice.zip", "class /home/ta/class.zip", "class of a learning system /home/ta/export.zip"
inline constexpr std::string_view kHandIn = "hand-in", kClass = "class",
                                  kLearningSystem = "class of a learning system";

inline std::string origin_text(std::string_view kind, const std::string& absolute_path) {
  return std::string(kind) + " " + absolute_path;
}
inline bool is_of_a_class(std::string_view origin) {
  return origin.starts_with(kClass);
}

struct SourceFile {
  std::string text;  // are the file's bytes
  std::string problem =
      {};  // not empty: the reason of its rejection, a sentence for the student; then `text` is empty
  std::string choice =
      {};  // not empty: a sentence for the student about the chosen one of several files, or another name
};

struct Submission {
  std::string name;                              // see names.h
  std::string origin;                            // "": a name that clashes
  std::map<std::string, SourceFile> files = {};  // by exercise file ("conj_grad.cpp"); only handed-in files
  std::string problem = {};  // not empty: why the whole submission is rejected, for the student
  bool unreadable = false;   // has a problem: an unknown format, or a damaged or encrypted archive
  Owner owner = {};
  std::string system = {};  // is the layout's name, as --from takes it: "canvas", "folders"
  std::string handed_in =
      {};  // as in the download (text/time_text.h); "": it has no time; "-": a table has an empty cell
  bool marked_late = false;     // by the learning system
  std::string about = {};       // is the text of about.txt, a student's answers on the course; "": none
  std::string known_as = {};    // is the name in the download if `name` is a code (class_folder/blind.h)
  std::string drawn_from = {};  // is the name for random inputs, from the class's record; "": `name`
};
inline const std::string& drawn_from(const Submission& submission) {
  return submission.drawn_from.empty() ? submission.name : submission.drawn_from;
}

struct Intake {
  std::vector<Submission> submissions;  // sorted by name; each has a name of its own
  // Describe each argument to staff in a line: a hand-in or a class. Of several arguments only classes.
  std::vector<std::string> taken_for;
  // These are lines for staff that a person must look at: files that belong to nobody, archives that could
  // not be opened, names that clash.
  std::vector<std::string> notices;
  std::map<std::string, std::string> whose_notice = {};  // maps a notice to its submission, if it has one
  // These are lines for staff about guessed names, files taken under other names, and students without a
  // hand-in that counts.
  std::vector<std::string> remarks;
  std::vector<Accounted> accounted;  // each file of the input, except those in names.h
};

// The files of the input that are in no hand-in that counts, for the record, pages and programs.
inline constexpr const char* kLeftOver = "left-over.json";  // in a folder of grades

// Writes the line for staff about a file that is left over.
std::string line_about(const Accounted& left_over);

// Lists all files except those of hand-ins, and the notices about no file.
std::vector<Accounted> listed(const Intake& intake);

// Writes an object: "left_over", "older" and "made", each a list of {"path", "reason", "whose"}; and
// "notices", lines for staff.
std::string left_over_json(const std::vector<Accounted>& listed);

// Limits the reading of one submission. Names of operating systems (names.h) use up nothing. A whole
// argument may have 10 times the entries, and its stream may unpack to 20 times its own size if that is more;
// honest files compress less than that.
struct IntakeLimits {
  std::size_t file_bytes = std::size_t{1} << 20;  // bounds one exercise file
  std::size_t unpacked_bytes = std::size_t{256}
                               << 20;  // bounds all bytes read, including nested archives and their files
  std::size_t stream_bytes = std::size_t{1} << 30;  // bounds a tar's whole stream; only a part of it is kept
  std::size_t entries = 200000;                     // bounds files and folders, also those in nested archives
};

// This is thrown for input that only a person can judge: an option confirms it.
struct Question : BadInput {
  Question(const std::string& line, const std::string& option_that_settles_it)
      : BadInput(line + " " + option_that_settles_it), option(option_that_settles_it) {}
  std::string option;
};
inline constexpr const char *kSaysClass = "--class", *kSaysReplace = "--replace";

struct IntakeChoices {
  bool classes = false;   // each of several arguments may be a class
  std::string from = {};  // is the layout (layouts/system.h), or "folders"; "": it is guessed
  KnownOwner known = {};  // comes from the roster, for names with several readings

  bool says_class() const { return classes || (!from.empty() && from != "folders"); }
};

}  // namespace grader::intake
