// STAFF ONLY. The sample class: submissions with known bugs and attacks, and what grading them must give. The
// files of list/, in the order of their names, list them:
//
//   {"samples": [{
//     "name":    "wrong-beta"                  of the archive or folder, without its ending
//     "shows":   "..."                         the bug, or what is right, in a line
//     "form":    "zip" | "tar.gz" | "folder"
//     "files":   {PATH IN THE ARCHIVE: CONTENT, ...}
//     "others":  "reference" | "stub"          optional: the files of all exercises that "files" does not name, at the
//                                              archive's top level
//     "patch":   "wrong-beta.patch"            optional: from patches/, applied to the solution files with -p1
//     "windows": true                          optional: solution files begin with a byte order mark and have CR LF
//     "cut":     1000                          optional: the bytes of the archive that are left, as after a
//                                              broken upload
//     "overwrite": [{"at": -6, "hex": "ff00"}] optional: bytes of the packed archive that are changed; -6 is the sixth
//                                              from the end
//     "showcase": true                         optional: one of the few that show every kind of sample
//     "beside_attacks": true                   optional: right, and graded beside the attacks of every place
//     "attack":  ATTACK                        optional: see below
//     "expect":  {"S1": {"status": "partly", "points": 12}, ...}
//                                              without points: all of them if it passed, or else none
//   }, ...]}
//
// CONTENT is "reference", "stub" or a folder of solutions/, which hold an exercise file of that name;
// {"text": "..."}; {"link": TARGET}, a symbolic link; or {"zeros": BYTES}, so many zero bytes.
//
// ATTACK makes a sample one of the corpus, which is graded place by place, apart from the class. Only attacks that the
// showcase has are in the class, too.
//
//   {"place": "run"                            build, start, run, protocol, archive, report or time
//    "fence": "..."                            what stops it
//    "most_points": {"S1": 0}                  of these exercises; or a number: of all of them together
//    "most_cpu_seconds": 10                    of ours
//    "also": ["crashed", ...]                  optional: statuses that are right, too, for the exercises that most_points
//                                              names: it depends on the machine which limit comes first
//    "no_pictures": true}                      optional: the student's report shows no picture of its run
//
// "expect" names every exercise whose file "files" names. What "others" fills in is expected to have passed
// ("reference") or not to be implemented ("stub"); all other exercises that "expect" does not name, to be missing.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace grader {

enum class SampleForm { zip, tar_gz, folder };

struct SampleFile {
  enum class Kind { solution, text, link, zeros };

  std::string path;  // in the archive
  Kind kind = Kind::solution;
  std::string value;        // the solution's folder, the text or the link's target
  std::uint64_t zeros = 0;  // bytes
};

struct ExpectedResult {
  std::string status;            // as to_string(Status) has it
  std::optional<double> points;  // nothing: all if it passed, or else none
};

struct Attack {
  std::string place, fence;
  std::map<std::string, double> most_points_of;  // by exercise
  std::optional<double> most_points;             // of all
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
  std::string list;  // that names it: "H1" for H1.json
  std::string name, shows;
  SampleForm form = SampleForm::zip;
  std::vector<SampleFile> files;  // sorted by path
  std::string patch;              // empty: none
  bool windows = false, showcase = false, beside_attacks = false;
  std::optional<std::uint64_t> cut;
  std::vector<Overwrite> overwrite;
  std::optional<Attack> attack;
  std::map<std::string, ExpectedResult> expected;  // by exercise id: every exercise of the course
  std::vector<std::string> listed;                 // of these, the ids that "expect" names

  std::string file_name() const;  // "wrong-beta.zip"
  bool in_class() const { return !attack || showcase; }
  bool graded_at(const std::string& place) const { return attack ? attack->place == place : beside_attacks; }
};

// The lists of PROJECT/grader/samples/list, for the exercises of PROJECT/handout/exercises.json. Throws BadInput
// with the file and the JSON path.
std::vector<Sample> read_samples(const std::filesystem::path& project);

}  // namespace grader
