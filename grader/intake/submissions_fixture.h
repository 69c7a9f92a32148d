// STAFF ONLY. For tests: writes submissions, and reads them.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "grader/course/input.h"
#include "grader/intake/archives/archive_builder.h"
#include "grader/intake/archives/sandboxed_archive.h"
#include "grader/intake/read_submissions.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline intake {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

inline Course two_exercises() {
  Course course;
  course.exercises.resize(3);
  course.exercises[0].file = "conj_grad.cpp";
  course.exercises[1].file = "normal_equations.cpp";
  course.exercises[2].file = "left_out.cpp";
  course.exercises[2].role = Role::absent;
  return course;
}

inline std::string zip(const std::string& path, const std::string& text = "int x;\n") {
  return ArchiveBuilder(Packing::zip).file(path, text).bytes();
}

// Opens the tests' archives: in a sandbox, if the environment's HAIR_READER names a reader.
inline const OpenArchive& opener() {
  static const char* program = std::getenv("HAIR_READER");
  static const std::unique_ptr<SandboxedReader> reader =
      program == nullptr ? nullptr : std::make_unique<SandboxedReader>(program, isolation_for_tests());
  static const OpenArchive open = reader ? reader->opener() : OpenArchive(open_here);
  return open;
}

class Submissions : public testing::Test {
 protected:
  Submissions() { signal(SIGPIPE, SIG_IGN); }

  fs::path write(const std::string& name, const std::string& bytes) const {
    fs::create_directories((dir_ / name).parent_path());
    std::ofstream(dir_ / name, std::ios::binary) << bytes;
    return dir_ / name;
  }
  static Intake take(const std::vector<fs::path>& arguments, const IntakeLimits& limits = {},
                     bool classes = false) {
    return read_submissions(arguments, two_exercises(), opener(), limits, {.classes = classes});
  }
  static std::vector<Submission> read(const std::vector<fs::path>& arguments,
                                      const IntakeLimits& limits = {}) {
    return take(arguments, limits).submissions;
  }
  static testing::AssertionResult has_notice(const Intake& intake, const std::vector<std::string>& parts) {
    return has_line(intake.notices, parts);
  }
  static testing::AssertionResult has_remark(const Intake& intake, const std::vector<std::string>& parts) {
    return has_line(intake.remarks, parts);
  }
  static testing::AssertionResult has_line(const Names& lines, const std::vector<std::string>& parts) {
    for (const std::string& notice : lines) {
      const bool one_line = notice.find('\n') == std::string::npos;
      if (one_line && std::all_of(parts.begin(), parts.end(), [&](const std::string& part) {
            return notice.find(part) != std::string::npos;
          }))
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << "no such line in: " << testing::PrintToString(lines);
  }
  // Returns the one submission in an archive of these bytes, as in a class.
  Submission only(const std::string& bytes, const IntakeLimits& limits = {}) const {
    const std::vector<Submission> all = read({write("only/alice.zip", bytes).parent_path()}, limits);
    if (all.size() != 1) throw std::runtime_error("expected one submission");
    return all.front();
  }
  static Names names(const std::vector<Submission>& submissions) {
    Names names;
    for (const Submission& submission : submissions) names.push_back(submission.name);
    return names;
  }
  // Writes "alice: conj=TEXT normal=TEXT" for each, with "!" and no text for a problem.
  static Names told(const std::vector<Submission>& submissions) {
    Names lines;
    for (const Submission& one : submissions) {
      std::string line = one.name + ":" + (one.problem.empty() ? "" : " !");
      for (const auto& [file, source] : one.files)
        line +=
            " " + file.substr(0, file.find('_')) + "=" + (source.problem.empty() ? "" : "!") + source.text;
      lines.push_back(line);
    }
    return lines;
  }
  static std::string bad_input(const std::vector<fs::path>& arguments, const IntakeChoices& choices = {}) {
    return tests::refusal<BadInput>(
        [&] { read_submissions(arguments, two_exercises(), opener(), {}, choices); });
  }

  hair::TemporaryFolder temporary_{"intake"};
  fs::path dir_ = temporary_.path();
};

inline testing::AssertionResult says(const std::string& message, const std::string& part) {
  if (message.find(part) != std::string::npos && message.find('\n') == std::string::npos) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "says: " << message << "\nnot:  " << part;
}

}  // namespace grader::intake
