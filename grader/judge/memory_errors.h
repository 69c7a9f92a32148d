// STAFF ONLY. The category "No memory errors": what the cases asked is asked once more, of a worker whose
// object is compiled with AddressSanitizer and UndefinedBehaviorSanitizer, until it tells of an error.
//
// The point is lost for an error, and for a program that ends where the other one went on: then memory that
// nobody wrote decides what it does. It is not lost for what is slow or takes much memory, since the
// sanitizers make it so; but for a file that does not become an object with them. Where nothing else is
// right, there is no code to speak of, and no point.
//
// This worker pays from the exercise's share of the budget, as the others do. It comes last: so it takes what
// they have left, and nothing from any of them. If they have left nothing, the point is lost like that of any
// category that comes too late.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "grader/judge/memory_points.h"
#include "grader/judge/student/recording.h"
#include "grader/judge/student/student.h"
#include "grader/judge/suite_table.h"
#include "grader/judge/trial.h"

namespace grader::inline judge {

class MemoryErrors {
 public:
  // `worker`: of the cases, `object`: the student's, with sanitizers; empty: there is none, and no point.
  // `earlier`: the exercise's other workers, which are finished first.
  MemoryErrors(const WorkerSetup& worker, std::filesystem::path object, std::vector<Student*> earlier,
               const Recording& recording, std::function<bool()> anything_right);

  Category category(const std::string& exercise);
  Student& student() { return student_; }

  // What the student reads of an error, in a sentence of ours, and the number of the call that met it; -1: it
  // was loaded. Empty: none was found.
  const std::string& message() const { return message_; }
  int call() const { return call_; }

 private:
  void look(Trial& trial);
  void ask_all(Trial& trial);
  [[noreturn]] void tell(Trial& trial, const std::string& sentence, const std::string& detail);

  std::shared_ptr<Allowance> paying_;
  std::filesystem::path object_;
  std::vector<Student*> earlier_;
  const Recording& recording_;
  std::function<bool()> anything_right_;
  WorkerSetup setup_;
  Student student_;
  std::string message_;
  int call_ = -1;
};

}  // namespace grader::judge
