// STAFF ONLY.
#include "grader/intake/names.h"

#include <gtest/gtest.h>

#include "grader/intake/canvas.h"

namespace grader {
namespace {

TEST(SubmissionName, IsSafeForFilesAndPages) {
  EXPECT_EQ(submission_name("Smith, Zo\xc3\xab <b>.zip"), "Smith__Zo____b_");
  EXPECT_EQ(submission_name("staff.zip"), "staff_");
  EXPECT_EQ(submission_name("grades.csv.zip"), "grades.csv_");
  EXPECT_EQ(submission_name("alice.v2.ZIP"), "alice.v2");
  EXPECT_EQ(submission_name("bob.pdf"), "bob");
  EXPECT_LE(submission_name(std::string(200, 'x') + ".zip").size(), 150u);
}

// So that no program takes it for an option, and no folder hides it.
TEST(SubmissionName, BeginsWithALetterOrADigit) {
  EXPECT_EQ(submission_name("-rf.zip"), "x-rf");
  EXPECT_EQ(submission_name("--out"), "x--out");
  EXPECT_EQ(submission_name("_alice"), "x_alice");
  EXPECT_EQ(submission_name(".hidden.zip"), "x.hidden");
  EXPECT_EQ(submission_name("..zip"), "x.");
  EXPECT_EQ(submission_name("=cmd.zip"), "x_cmd");
  EXPECT_EQ(submission_name(".zip"), "x");
  EXPECT_EQ(submission_name("\xc3\x84rger.zip"), "x__rger");
  EXPECT_EQ(submission_name("7of9.zip"), "7of9");
  for (int byte = 1; byte < 256; ++byte) {
    const std::string name = submission_name(std::string(1, static_cast<char>(byte)) + "name");
    EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(name.front()))) << byte << ": " << name;
  }
}

TEST(SubmissionName, AmongEqualsDependsOnThePathAlone) {
  const std::string name = name_among_equals("x_1", "/class/x 1");
  EXPECT_TRUE(name.starts_with("x_1-")) << name;
  EXPECT_EQ(name, name_among_equals("x_1", "/class/x 1"));
  EXPECT_NE(name, name_among_equals("x_1", "/class/x_1"));
  EXPECT_EQ(name, submission_name(name)) << "it is a safe name";
}

const FileNames exercise_names{"conj_grad.cpp", "normal_equations.cpp"};

// "doe_12 conj_grad.cpp 1": what a name says; "" if it is not Canvas's.
std::string canvas(std::string_view name) {
  const auto found = canvas_name(name, exercise_names);
  if (!found) return "";
  return found->student + " " + found->file +
         (found->version > 0 ? " " + std::to_string(found->version) : "");
}

TEST(CanvasName, HasAStudentAndAFile) {
  EXPECT_EQ(canvas("doe_12347_678901_conj_grad.cpp"), "doe_12347 conj_grad.cpp");
  EXPECT_EQ(canvas("doe_LATE_12347_678901_conj_grad.cpp"), "doe_12347 conj_grad.cpp");
  EXPECT_EQ(canvas("doe_jane-mary_12347_678901_conj_grad.cpp"), "doe_jane-mary_12347 conj_grad.cpp");
  EXPECT_EQ(canvas("doe_2_12347_678901_conj_grad.cpp"), "doe_2_12347 conj_grad.cpp");
  EXPECT_EQ(canvas("doe_12347_678901_my_handin.zip"), "doe_12347 my_handin.zip");
}

TEST(CanvasName, CountsLaterHandIns) {
  EXPECT_EQ(canvas("doe_12347_678901_conj_grad-1.cpp"), "doe_12347 conj_grad.cpp 1");
  EXPECT_EQ(canvas("doe_12347_678901_conj_grad-12.cpp"), "doe_12347 conj_grad.cpp 12");
  EXPECT_EQ(canvas("doe_12347_678901_conj_grad-x.cpp"), "doe_12347 conj_grad-x.cpp");
  EXPECT_EQ(canvas("doe_12347_678901_conj_grad-99999999999.cpp"), "doe_12347 conj_grad-99999999999.cpp");
  EXPECT_EQ(canvas("doe_12347_678901_handin-1.zip"), "doe_12347 handin-1.zip");
}

TEST(CanvasName, IsNoOther) {
  for (const char* name :
       {"conj_grad.cpp", "doe_conj_grad.cpp", "doe_12347_conj_grad.cpp", "_12_34_conj_grad.cpp",
        "_LATE_12_34_conj_grad.cpp", "doe_12_34_", "doe_12_34", "doe__34_conj_grad.cpp", "", "_"})
    EXPECT_EQ(canvas(name), "") << name;
}

}  // namespace
}  // namespace grader
