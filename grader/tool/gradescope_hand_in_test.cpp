// STAFF ONLY. Tests owners in Gradescope's metadata, and results.json while a hand-in is graded.
#include "grader/tool/gradescope_hand_in.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/report/gradescope_rules.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline tool {
namespace {

using tests::says;

namespace fs = std::filesystem;

class Gradescope : public testing::Test {
 protected:
  fs::path metadata(const std::string& text) const {
    std::ofstream(folder_.path() / "submission_metadata.json") << text;
    return folder_.path() / "submission_metadata.json";
  }
  nlohmann::json results() const {
    const std::string text = hair::bytes_of(folder_.path() / "results/results.json");
    EXPECT_EQ(broken_rules(text), std::vector<std::string>{});
    return nlohmann::json::parse(text);
  }

  const hair::TemporaryFolder folder_{"gradescope-test"};
  const Course course_ = read_course(HAIR_EXERCISES_JSON);
};

TEST_F(Gradescope, AGroupHasTheSmallestNumberOfItsMembersWhoeverHandsIn) {
  EXPECT_EQ(read_metadata(metadata(R"({"id": 9, "created_at": "2026-03-04T10:15:00.0-08:00",
      "users": [{"id": 4711, "name": "../../x", "email": "\u0000"}]})"))
                .student,
            "4711");
  for (const char* users : {R"([{"id": 12}, {"id": 7}])", R"([{"id": 7}, {"id": 12}])"})
    EXPECT_EQ(read_metadata(metadata(R"({"created_at": "t", "users": )" + std::string(users) + "}")).student,
              "7");
}

TEST_F(Gradescope, OddMetadataIsToldInALine) {
  const std::pair<const char*, const char*> slips[] = {
      {"", "submission_metadata.json"},
      {"[]", "it must be an object with \"users\""},
      {R"({"created_at": "t"})", "it must be an object with \"users\""},
      {R"({"created_at": "t", "users": {}})", "users"},
      {R"({"created_at": "t", "users": []})", "users: there is nobody"},
      {R"({"created_at": "t", "users": [7]})", "users[0]: it must be an object with \"id\""},
      {R"({"created_at": "t", "users": [{"id": "7"}]})", "users[0].id"},
      {R"({"created_at": "t", "users": [{"id": -7}]})", "users[0].id"},
      {R"({"created_at": "t", "users": [{"id": 7.5}]})", "users[0].id"},
      {R"({"users": [{"id": 7}]})", "it must be an object with \"created_at\""},
      {R"({"created_at": 5, "users": [{"id": 7}]})", "created_at"},
  };
  for (const auto& [text, sentence] : slips) try {
      read_metadata(metadata(text));
      ADD_FAILURE() << text << " was read";
    } catch (const BadInput& error) {
      EXPECT_TRUE(says(std::string(error.what()), sentence)) << text << ": " << error.what();
      EXPECT_FALSE(says(error.what(), "\n"));
    }
}

TEST_F(Gradescope, ResultsAreWholeFromTheBeginningAndNameWhatIsNotGradedYet) {
  GradescopeResults file(folder_.path(), course_, {});
  EXPECT_EQ(results()["score"], 0);
  EXPECT_TRUE(says(results()["output"].get<std::string>(), "S1, S2, P1")) << results();
  EXPECT_FALSE(results()["extra_data"].contains("isolation")) << "nothing ran so far";

  file.belong_to({"4711", "2026-03-04"});
  const auto names = [&](const std::string& id) {
    const std::string output = results()["output"];
    return output.find(" " + id + ",") != std::string::npos ||
           output.find(" " + id + ".") != std::string::npos;
  };
  SubmissionResult result;
  for (const Exercise& exercise : course_.exercises) {
    if (!is_asked_for(exercise.role)) continue;
    EXPECT_TRUE(names(exercise.id)) << exercise.id;
    result.exercises.push_back({.id = exercise.id, .points = 3, .max_points = 3});
    file.write(result);
    EXPECT_FALSE(names(exercise.id)) << exercise.id;
    EXPECT_EQ(results()["score"], 3 * static_cast<int>(result.exercises.size()));
  }
  EXPECT_EQ(results()["output"], "");
  EXPECT_EQ(results()["extra_data"]["student"], "4711");
  EXPECT_EQ(results()["extra_data"]["handed_in"], "2026-03-04");
  EXPECT_EQ(results()["extra_data"]["isolation"], "namespaces");
}

TEST_F(Gradescope, WhatCouldNotBeGradedIsNotTheStudentsFault) {
  const GradescopeResults file(folder_.path(), course_, {});
  file.could_not_grade();
  EXPECT_EQ(results()["score"], 0);
  EXPECT_TRUE(says(results()["output"].get<std::string>(), "not your fault"));
}

}  // namespace
}  // namespace grader::tool
