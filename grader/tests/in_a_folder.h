// STAFF ONLY. For tests: a new folder in which hairgrade runs as a person starts it, with its own course.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader {

class InAFolder : public testing::Test {
 protected:
  explicit InAFolder(const nlohmann::json& course) {
    write("course.json", course.dump());
    write("secret", "a secret for this test");
  }
  std::string path(const std::string& name) const { return (root_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
    return path(name);
  }
  std::string read(const std::string& name) const { return hair::bytes_of(root_ / name); }
  // Runs a command about the folder grades/.
  ProgramRun run(std::vector<std::string> words) const {
    words.insert(words.end(), {"--out", path("grades")});
    return run_hairgrade(words);
  }
  // Grades without pictures, into grades/; `words` follow the command's name.
  ProgramRun grade(std::vector<std::string> words) const {
    words.insert(words.begin(), "grade");
    words.insert(words.end(), {"--secret", path("secret"), "--cache", path("cache"), "--course",
                               path("course.json"), "--no-images"});
    return run(words);
  }
  // Expects exit code 2, and one line with these words.
  static void expect_refused(const ProgramRun& run, const std::string& because) {
    EXPECT_EQ(run.code, 2) << run.errors;
    EXPECT_TRUE(tests::says(run.errors, because));
    EXPECT_EQ(std::ranges::count(run.errors, '\n'), 1) << run.errors;
  }

  hair::TemporaryFolder temporary_{"hairgrade"};
  std::filesystem::path root_ = temporary_.path();
};

}  // namespace grader
