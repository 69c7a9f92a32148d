// STAFF ONLY. The category "No memory errors" repeats the questions of the cases to a worker whose object is
// compiled with AddressSanitizer and UndefinedBehaviorSanitizer, until it reports an error.
//
// The point is lost for an error, for a program that ends where the other one went on (unset memory then
// decides), and for a file that does not compile with sanitizers. Slow code or much memory costs no point,
// since the sanitizers cause both. If no other category is right, the exercise has no code to check, and
// there is no point.
//
// This worker has the rest of the exercise's budget, and comes last, so that it takes nothing from other
// categories. If nothing is left, the point is lost like that of any category that comes too late.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "grader/judge/cases/suite_table.h"
#include "grader/judge/cases/trial.h"
#include "grader/judge/memory_points.h"
#include "grader/judge/student/recording.h"
#include "grader/judge/student/student.h"

namespace grader::inline judge {

class MemoryErrors {
 public:
  // `worker` is the setup of the cases, `object` the student's object with sanitizers; empty: there is none,
  // and no point. `earlier` are the exercise's other workers, which end first.
  MemoryErrors(const WorkerSetup& worker, std::filesystem::path object, std::vector<Student*> earlier,
               const Recording& recording, std::function<bool()> anything_right);

  Category category(const std::string& exercise);
  Student& student() { return student_; }

  // Return our sentence about the error for the student, and the number of the call in which it happened, or
  // -1 while the object was loaded. Empty: no error was found.
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
