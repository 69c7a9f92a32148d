// STAFF ONLY. The sample class: submissions with known bugs and attacks, and their expected results. A
// group of them is a file, GROUP.samples, or an exercise's wrong.samples, with a line for each fact. Lines
// before the first sample hold for all samples that don't say otherwise:
//
//   title Bugs in H2
//   file plain angular_springs.cpp
//   others reference
//
//   sample h2-acos
//   shows The angle is acos(u1 . u2).
//   form zip
//   fails H2 NearlyStraight
//   edit
//   -  bend.phi = std::atan2(s, dot);
//   +  bend.phi = std::acos(dot);
//
//   title TEXT           names the group: once in a file, before its samples
//   sample NAME          names the archive or folder, without its extension
//   shows TEXT           the bug, or the right property, in a line
//   form FORM            zip, tar.gz or folder
//   file SOLUTION PATH   an exercise file from "reference", "stub" or a right solution (solution_files.h)
//   text TEXT PATH       a file that holds this text, a JSON string
//   link TARGET PATH     a symbolic link
//   zeros BYTES PATH     as many zero bytes. A PATH with odd letters is a JSON string, too
//   others SOLUTION      adds all other exercises' files at the top: reference or stub; or none
//   edit [FILE]          changes a solution's file: struct Edit. Without FILE: the sample's first "file"
//   part NAME            before the samples: names the next lines +; an edit's line *NAME inserts them
//   windows              solution files begin with a byte order mark and have CR LF
//   cut BYTES            keeps these first bytes of the archive, as after a broken upload
//   overwrite AT HEX     changes bytes of the packed archive; -6 is the sixth from the end
//   showcase [first]     one of the few that show every kind of sample; first: a newcomer sees it
//   beside-attacks       right, and graded with the attacks of every place
//   status ID STATUS     belongs to an exercise, or to "all"
//   fails ID NAMES       the categories that fail (categories.json), which take their points; the
//                        status is then "partly", unless one is given
//   points ID POINTS     repeats the points in the showcase: an error in scoring can't confirm itself
//   useless TEXT         why it loses more than three categories: no part of its answer can be used
//
// An exercise without such a line has passed if it has a file, and is missing if not. A file of "others" has
// passed ("reference") or is not implemented ("stub"), and takes no status.
//
// An attack belongs to the corpus, which is graded place by place, apart from the class. Only the showcase's
// attacks are in the class, too.
//
//   place PLACE          build, start, run, protocol, archive, report or time
//   fence TEXT           what stops it
//   most ID POINTS       bounds its points; or those of "all" exercises together
//   seconds SECONDS      bounds its CPU time in the grader
//   also STATUS          a second right status for "most" exercises: the first limit depends on the machine
//   no-pictures          the student's report shows no picture of its run
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace grader::inline samples {

// A change of a solution's file, which gives a sample its bug: lines of the solution, which occur
// once, and their replacement.
//
//   -  double k = strand.stretch_rigidity / l0;    this line is removed
//   =  double l0 = strand.rest_length(i);          this line stays: it shows the place
//   +  double k = strand.stretch_rigidity;         this line is added
struct EditLine {
  char mark = '=';
  std::string text;
};

struct Edit {
  std::string where;  // "H1.samples:12", for messages
  std::string file;   // "stretch_springs.cpp"
  std::vector<EditLine> lines;
};

enum class SampleForm { zip, tar_gz, folder };

struct SampleFile {
  enum class Kind { solution, text, link, zeros };

  std::string path;  // in the archive
  Kind kind = Kind::solution;
  std::string value;        // is the solution's folder, the text or the link's target
  std::uint64_t zeros = 0;  // counts bytes
};

struct ExpectedResult {
  std::string status;                    // as in to_string(Status)
  std::optional<double> points;          // empty: all if it passed, or else none
  std::vector<std::string> failed = {};  // are the titles of the categories that fail; empty: any may
};

struct Attack {
  std::string place, fence;
  std::map<std::string, double> most_points_of;  // by exercise
  std::optional<double> most_points;             // bounds the sum
  double most_cpu_seconds = 0;
  std::vector<std::string> also;
  bool no_pictures = false;
};

inline constexpr std::array<const char*, 7> kPlaces{"build",   "start",  "run", "protocol",
                                                    "archive", "report", "time"};

struct Overwrite {
  std::int64_t at = 0;
  std::string bytes;
};

struct Sample {
  std::string group, title;  // "H1" for reference/H1/wrong.samples, and the file's title
  std::string name, shows;
  SampleForm form = SampleForm::zip;
  std::vector<SampleFile> files;  // sorted by path
  std::vector<Edit> edits;
  bool windows = false, showcase = false, first = false, beside_attacks = false;
  std::optional<std::uint64_t> cut;
  std::vector<Overwrite> overwrite;
  std::optional<Attack> attack;
  std::map<std::string, ExpectedResult> expected;  // by exercise id: every exercise of the course
  std::vector<std::string> listed;                 // are the ids that have a line, in the course's order
  std::string useless;                             // says why it may lose many categories, or is empty

  std::string file_name() const;  // "wrong-beta.zip"
  bool in_class() const { return !attack || showcase; }
  bool graded_at(const std::string& place) const { return attack ? attack->place == place : beside_attacks; }
};

// Returns the exercises' groups, PROJECT/reference/<ID>/wrong.samples, and those of
// PROJECT/grader/samples/groups, in the order of their names. The group "right" also has the right programs
// of all exercises: the sample right-plain, of reference/<ID>/right/plain.cpp, and so on. Throws BadInput
// with file and line.
std::vector<Sample> read_samples(const std::filesystem::path& project);

// Writes the samples as Markdown tables, the class by group, attacks by place. "gets" lists exercises with a
// line that don't pass, and their remaining points, if any.
std::string table_of(const std::vector<Sample>& samples);

}  // namespace grader::samples
