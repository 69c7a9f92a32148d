// STAFF ONLY. Student files become objects, with a precompiled header and without.
#include "grader/compile/compiler.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "grader/course/course.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kCache = HAIR_TEST_CACHE;

class CompilerTest : public testing::Test {
 protected:
  // The precompiled header may be of an earlier run; objects may not.
  CompilerTest() {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(kCache, none))
      if (entry.path().extension() == ".so") fs::remove(entry.path());
  }

  std::string reference(const Exercise& exercise) const {
    std::ostringstream text;
    text << std::ifstream(fs::path(HAIR_PROJECT) / "reference" / exercise.file).rdbuf();
    return text.str();
  }

  const Course course_ = read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json");
  const Exercise& with_eigen_ = *course_.find("H1");
  const StagedKit kit_{HAIR_KIT_DIR, course_};
  const Compiler compiler_{kit_, kCache, true};
};

TEST_F(CompilerTest, WhatMustComeBeforeEigenMayComeBeforeEigen) {
  // Eigen has this function with this macro alone, which comes too late for a precompiled header.
  const std::string source = "#define EIGEN_RUNTIME_NO_MALLOC\n" + reference(with_eigen_) +
                             "bool may_allocate() { return Eigen::internal::is_malloc_allowed(); }\n";
  const Compiled compiled = compiler_.compile(with_eigen_, source, kit_.new_job("before-eigen"));
  EXPECT_FALSE(compiled.object.empty()) << compiled.log;
}

TEST_F(CompilerTest, MessagesAreThoseOfTheFileItself) {
  const Compiled compiled = compiler_.compile(
      with_eigen_, "#include \"hair/stretch_springs.h\"\nint one = two;\n", kit_.new_job("wrong"));
  EXPECT_TRUE(compiled.object.empty());
  EXPECT_EQ(compiled.messages, "stretch_springs.cpp:2:11: error: 'two' was not declared in this scope\n");
  EXPECT_EQ(compiled.log.find("precompiled"), std::string::npos) << compiled.log;
}

TEST_F(CompilerTest, AnExerciseWithoutEigenHasNone) {
  const Exercise& without = *course_.find("S1");
  const Compiled compiled =
      compiler_.compile(without, "#include <Eigen/Core>\n" + reference(without), kit_.new_job("without"));
  EXPECT_TRUE(compiled.object.empty());
  EXPECT_NE(compiled.messages.find("Eigen/Core: No such file"), std::string::npos) << compiled.messages;
}

}  // namespace
}  // namespace grader
