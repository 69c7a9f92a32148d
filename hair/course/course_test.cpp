#include "hair/course/course.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

class CourseFiles : public testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(dir_ / name, std::ios::binary) << text;
    return dir_ / name;
  }

  static std::string exercise(const std::string& id, const std::string& prerequisites = "[]",
                              const std::string& points = "10", const std::string& role = "\"assigned\"") {
    return R"({"id": ")" + id + R"(", "title": "T", "file": ")" + id +
           R"x(.cpp", "functions": ["f()"], "header": "a.h", "prerequisites": )x" + prerequisites +
           R"(, "libraries": [], "points": )" + points + R"(, "role": )" + role + "}";
  }
  static std::string list(const std::string& exercises) { return "{\"exercises\": [" + exercises + "]}"; }

  // The error of reading `exercises` (and `course`, if there is one); "" if there is none.
  std::string complaint(const std::string& exercises, const std::string& course = "") const {
    const fs::path file = write("exercises.json", exercises);
    return tests::refusal<BadInput>([&] {
      if (course.empty()) {
        read_course(file);
      } else {
        read_course(file, write("course.json", course));
      }
    });
  }
  std::string course_complaint(const std::string& course) const {
    return complaint(list(exercise("S1") + "," + exercise("S2", "[\"S1\"]")), course);
  }

  TemporaryFolder temporary_{"course"};
  fs::path dir_ = temporary_.path();
};

// One line that contains `part`.
testing::AssertionResult says(const std::string& message, const std::string& part) {
  if (message.find(part) != std::string::npos && message.find('\n') == std::string::npos) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "says: " << message << "\nnot:  " << part;
}

TEST_F(CourseFiles, TheProjectsOwnListIsRead) {
  const Course course = read_course(HAIR_EXERCISES_JSON);
  ASSERT_NE(course.find("S1"), nullptr);
  EXPECT_EQ(course.find("S1")->file, "conj_grad.cpp");
  EXPECT_EQ(course.find("S1")->role, Role::assigned);
  ASSERT_NE(course.find("S2"), nullptr);
  EXPECT_EQ(course.find("S2")->prerequisites, std::vector<std::string>{"S1"});
  EXPECT_EQ(course.find("none"), nullptr);
}

TEST_F(CourseFiles, ACourseFileChangesOnlyWhatItNames) {
  const fs::path exercises = write("exercises.json", list(exercise("S1") + "," + exercise("S2", "[\"S1\"]")));
  const fs::path file =
      write("course.json", R"({"exercises": {"S1": {"role": "given"}, "S2": {"points": 2.5}}})");
  const Course course = read_course(exercises, file);
  EXPECT_EQ(course.find("S1")->role, Role::given);
  EXPECT_EQ(course.find("S1")->points, 10);
  EXPECT_EQ(course.find("S2")->role, Role::assigned);
  EXPECT_EQ(course.find("S2")->points, 2.5);
}

TEST_F(CourseFiles, RolesHaveTheNamesThatTheFilesUse) {
  for (const char* role : {"assigned", "optional", "given", "absent"}) {
    const fs::path file =
        write("exercises.json", list(exercise("S1", "[]", "1", std::string(1, '"') + role + "\"")));
    EXPECT_EQ(to_string(read_course(file).find("S1")->role), role);
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST_F(CourseFiles, SayWhatIsWrongInTheListOfExercises) {
  const std::string s1 = exercise("S1"),
                    before = "exercises[0].prerequisites[0]: no such exercise stands before S1";
  const std::pair<std::string, std::string> rows[] = {
      {"{\"exercises\": [\n  {\"id\" \"S1\"}]}", "exercises.json: line 2, column "},
      {"", "line 1, column 1: not JSON"},
      {"{\"exercises\": []} x", "line 1, column "},
      {"{\"exercises\": \"\xff\"}", "not JSON"},
      {R"({"exercise": []})", "exercises.json: unknown key \"exercise\""},
      {R"({"exercises": [{"id": "S1"}]})", "exercises[0]: \"title\" is missing"},
      {"[]", "[] is not an object"},
      {R"({"exercises": {}})", "exercises: {} is not a list"},
      {list("7"), "exercises[0]: 7 is not an object"},
      {list(exercise("S1", "[3]")), "exercises[0].prerequisites[0]: 3 is not text"},
      {list(s1 + "," + s1), "exercises[1].id: \"S1\" is already taken"},
      {list(s1 + "," + replaced(exercise("S2"), "S2.cpp", "S1.cpp")),
       "exercises[1].file: \"S1.cpp\" is already S1's"},
      {list(exercise("../S1")), "exercises[0].id: "},
      {list(replaced(s1, "a.h", "../a.h")), "exercises[0].header: leaves the project"},
      {list(replaced(s1, "S1.cpp", "a/S1.cpp")), "exercises[0].file: "},
      {list(exercise("S1", "[\"S1\"]")), before},
      {list(exercise("S1", "[\"S2\"]") + "," + exercise("S2")), before},
  };
  for (const auto& [text, sentence] : rows) EXPECT_TRUE(says(complaint(text), sentence)) << text;
  for (const char* points : {"-1", "\"10\"", "1e7", "null", "-1e-300"})
    EXPECT_TRUE(says(complaint(list(exercise("S1", "[]", points))), "exercises[0].points: "));
  for (const char* points : {"NaN", "1e999", "Infinity"})
    EXPECT_TRUE(says(complaint(list(exercise("S1", "[]", points))), "not JSON"));
  EXPECT_EQ(complaint(list(exercise("S1", "[]", "0"))), "");
  EXPECT_TRUE(says(tests::refusal<BadInput>([&] { read_course(dir_ / "none.json"); }),
                   "none.json: can't be read (No such file or directory)"));
  EXPECT_THROW(read_course(dir_), BadInput);
}

TEST_F(CourseFiles, SayWhatIsWrongInACoursesOwnFile) {
  const std::pair<const char*, const char*> rows[] = {
      {"{}", "\"exercises\" is missing"},
      {R"({"exercises": {"S1": {"points": 1}, "S1": {"points": 2}}})", "\"S1\" stands twice"},
      {R"({"exercises": {"S1": {"rolle": "given"}}})",
       "course.json: exercises.S1: unknown key \"rolle\"; known here: role, points"},
      {R"({"exercises": {"S1": "given"}})", "exercises.S1: \"given\" is not an object"},
      {R"({"exercises": {"S1": {"role": null}}})", "exercises.S1.role: null is not text"},
      {R"({"exercises": {"S1": {"role": "Given"}}})",
       "exercises.S1.role: unknown role; write assigned, optional, given or absent"},
      {R"({"exercises": {"S9": {}}})", "exercises.S9: there is no such exercise; known: S1, S2"},
      {R"({"exercises": {"S1": {"role": "absent"}}})",
       "course.json: exercises: S2 is assigned but needs S1, which is absent"},
      {R"({"exercises": {"S1": {"role": "absent"}, "S2": {"role": "optional"}}})",
       "S2 is optional but needs S1"},
      {"{\"exercises\": {\"\\u001b[2J\\n\": {}}}", "exercises.\\x1b[2J\\x0a: there is no such exercise"},
  };
  for (const auto& [text, sentence] : rows) EXPECT_TRUE(says(course_complaint(text), sentence)) << text;
  EXPECT_EQ(course_complaint(R"({"exercises": {"S1": {"role": "absent"}, "S2": {"role": "absent"}}})"), "");
}

TEST_F(CourseFiles, WhatTheCourseHasIsNotAbsent) {
  const fs::path exercises = write("exercises.json", list(exercise("S1") + "," + exercise("S2", "[\"S1\"]")));
  const fs::path file =
      write("course.json",
            R"({"exercises": {"S2": {"role": "absent"}}, "budget": {}, "hand_in": {}, "partial": true})");
  const Course course = read_course(exercises, file);
  EXPECT_TRUE(course.has("S1"));
  EXPECT_FALSE(course.has("S2") || course.has("none"));
  EXPECT_EQ(course.absent(), std::vector<std::string>{"S2"});
  EXPECT_TRUE(calls_absent(std::vector<std::string>{"S1", "S2"}, course.absent()));
  EXPECT_FALSE(calls_absent(std::vector<std::string>{"S1"}, course.absent()));
}

}  // namespace
}  // namespace hair
