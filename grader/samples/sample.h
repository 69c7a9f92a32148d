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
//     "showcase": true                         optional: one of the few that show every kind of sample
//     "expect":  {"S1": {"status": "partly", "points": 12}, ...}
//                                              without points: all of them if it passed, or else none
//   }, ...]}
//
// CONTENT is "reference", "stub" or a folder of solutions/, which hold an exercise file of that name;
// {"text": "..."}; {"link": TARGET}, a symbolic link; or {"zeros": BYTES}, so many zero bytes.
//
// "expect" names every exercise whose file "files" names. What "others" fills in is expected to have passed
// ("reference") or not to be implemented ("stub"); all other exercises that "expect" does not name, to be missing.
#pragma once

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

struct Sample {
  std::string list;  // that names it: "H1" for H1.json
  std::string name, shows;
  SampleForm form = SampleForm::zip;
  std::vector<SampleFile> files;  // sorted by path
  std::string patch;              // empty: none
  bool windows = false, showcase = false;
  std::optional<std::uint64_t> cut;
  std::map<std::string, ExpectedResult> expected;  // by exercise id: every exercise of the course
  std::vector<std::string> listed;                 // of these, the ids that "expect" names

  std::string file_name() const;  // "wrong-beta.zip"
};

// The lists of PROJECT/grader/samples/list, for the exercises of PROJECT/handout/exercises.json. Throws BadInput
// with the file and the JSON path.
std::vector<Sample> read_samples(const std::filesystem::path& project);

}  // namespace grader
