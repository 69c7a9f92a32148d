// STAFF ONLY. A plan that nodes of a cluster carry out: a folder in the folder of grades, shared by all nodes
// and for its owner alone. One machine makes it, sends tasks, and merges results into the record; a
// task only reads the plan and writes results. Each file appears in full or not at all.
//
//   plan, course.json, secret   of hairgrade grade
//   hand-ins/N                  are numbered from 0, in the order of their names
//   first                       comes from the first task: the reference, and what nodes must have in common
//   cache/                      holds precompiled headers and the reference's pictures: made once
//   arrays/A, logs/A-K          are the hand-ins of each task, and the output of task K
//   refused/NODE                is there once a node has lacked a part
//   results/N                   has the fingerprint in its first line
//   collected                   numbers the results that are in the record
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/grading/grading.h"
#include "grader/intake/submission.h"
#include "grader/record/people_fields.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "hair/io/files/read_file.h"

namespace grader::inline class_folder {

inline constexpr const char* kCollectLog = ".collect.log";  // is in the folder of grades: the last job's

struct PlanFacts {
  std::vector<std::string> words;  // are those of hairgrade's command line
  std::filesystem::path folder;    // is the one that hairgrade began in
  std::string made_by;             // is JSON of grading/made_by.h
  std::optional<std::string> only = {};
  std::vector<std::size_t> asked = {};  // leaves out those whose recorded result stays
  std::size_t hand_ins = 0;
  double began = 0;  // in seconds since 1970
};

struct FirstTask {
  TimingByExercise reference;
  std::string common;  // is a hash of compiler, suite, course and renderer
  double seconds = 0;  // is the time of a right hand-in
};

struct SentArray {
  std::string job = {};                                 // is Slurm's number; "": it was not sent
  std::string without = {};                             // lists nodes that had refused before
  std::vector<std::vector<std::size_t>> hand_ins = {};  // by task
};

struct Collected {
  std::vector<std::size_t> hand_ins;
};

class SharedPlan {
 public:
  // Returns the one of a folder of grades, if there is one.
  static std::optional<SharedPlan> in(const std::filesystem::path& grades);
  // Makes its folder. Throws BadInput if it can't be written.
  static SharedPlan make(const std::filesystem::path& grades);
  explicit SharedPlan(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  bool has(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  // Throws BadInput if the disk is full, or if this machine may not write there.
  void write(const std::string& name, const std::string& bytes) const;
  template <class T>
  void put(const std::string& name, const T& value) const {
    write(name, json_text(value, -1));
  }
  template <class T>
  T get(const std::string& name) const {
    return from_json_text<T>(hair::bytes_of(folder_ / name), (folder_ / name).string());
  }

  std::vector<SentArray> arrays() const;
  std::string nodes_that_refused() const;  // "n1,n2"
  void forget_refusals() const;
  // Ends it, also where a process still writes there, or a shared folder keeps removed files.
  void remove() const;
  // Removes what ended plans and their last jobs have left in a folder of grades: it has people's names.
  static void clear(const std::filesystem::path& grades);

  void put_result(std::size_t number, const std::string& fingerprint, const Graded& graded) const;
  std::string fingerprint(std::size_t number) const;       // "" if there is no result
  std::optional<Graded> graded(std::size_t number) const;  // nothing if there is none

  // Throws BadInput if this machine can't write there, or if its clock is wrong.
  void try_it(const std::string& node) const;

 private:
  std::filesystem::path folder_;
};

inline std::string numbered(const std::string& folder, std::size_t number) {
  return folder + "/" + std::to_string(number);
}

}  // namespace grader::class_folder

namespace grader {

// Texts that may hold any bytes are written as pictures are.
inline const Rows<SourceFile>& rows_of(As<SourceFile>) {
  using T = SourceFile;
  static const Rows<T> all = {picture("text", &T::text), picture("problem", &T::problem),
                              picture("choice", &T::choice)};
  return all;
}
inline const Rows<Submission>& rows_of(As<Submission>) {
  using T = Submission;
  static const Rows<T> all = {
      field("name", &T::name),         picture("origin", &T::origin),       field("files", &T::files),
      picture("problem", &T::problem), field("unreadable", &T::unreadable), field("owner", &T::owner),
      field("system", &T::system),     field("handed_in", &T::handed_in),   field("late", &T::marked_late),
      picture("about", &T::about),     field("known_as", &T::known_as),     field("from", &T::drawn_from)};
  return all;
}
inline const Rows<PlanFacts>& rows_of(As<PlanFacts>) {
  using T = PlanFacts;
  static const Rows<T> all = {field("words", &T::words),     field("folder", &T::folder),
                              field("made_by", &T::made_by), field("only", &T::only),
                              field("asked", &T::asked),     field("hand_ins", &T::hand_ins),
                              field("began", &T::began)};
  return all;
}
inline const Rows<FirstTask>& rows_of(As<FirstTask>) {
  using T = FirstTask;
  static const Rows<T> all = {field("reference", &T::reference), field("common", &T::common),
                              field("seconds", &T::seconds)};
  return all;
}
inline const Rows<SentArray>& rows_of(As<SentArray>) {
  using T = SentArray;
  static const Rows<T> all = {field("job", &T::job), field("without", &T::without),
                              field("hand_ins", &T::hand_ins)};
  return all;
}
inline const Rows<Collected>& rows_of(As<Collected>) {
  static const Rows<Collected> all = {field("hand_ins", &Collected::hand_ins)};
  return all;
}
inline const Rows<Graded>& rows_of(As<Graded>) {
  using T = Graded;
  static const Rows<T> all = {field("result", &T::result), field("timing", &T::timing),
                              field("study", &T::study), field("problems", &T::problems)};
  return all;
}

}  // namespace grader
