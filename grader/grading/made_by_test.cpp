// STAFF ONLY. Tests that the settings of a folder come back whole, and that each difference has a sentence.
#include "grader/grading/made_by.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "hair/io/files/temporary_folder.h"

namespace grader::inline grading {
namespace {

MadeBy three_exercises() {
  MadeBy made;
  made.exercises = {{"S1", Role::assigned, 32},
                    {"S2", Role::assigned, 10},
                    {"H3", Role::optional, 2.5},
                    {"H4", Role::given, 0},
                    {"H5", Role::absent, 0}};
  made.suite = "hash of a suite";
  made.secret = "hash of a secret";
  return made;
}

// Returns the differences, and the ways out; both are empty if there are none.
std::pair<std::string, std::string> told(const MadeBy& there, const MadeBy& here) {
  std::pair<std::string, std::string> all;
  for (const Difference& one : differences(there, here)) {
    all.first += one.what + ". ";
    all.second += one.way + ". ";
  }
  return all;
}

using Told = std::pair<std::string, std::string>;

TEST(MadeBy, ComesBackWhole) {
  MadeBy made = three_exercises();
  made.budget = {{"seconds", "20"}};
  made.isolation = Isolation::none;
  EXPECT_EQ(made_by_from_json(to_json(made)), made);
  made.images = false;
  made.partial = true;
  EXPECT_EQ(made_by_from_json(to_json(made)), made);
}

TEST(MadeBy, OfAHandInHasTheExercisesOfOthersAsLeftOut) {
  const hair::TemporaryFolder folder("made-by");
  std::ofstream(folder.path() / "file") << "x";
  GradingSettings settings;
  settings.kit = settings.suite = settings.scenes = folder.path() / "file";
  settings.secret = std::string(32, 's');
  for (const MadeBy::Rule& rule : three_exercises().exercises) {
    Exercise exercise;
    exercise.id = rule.id;
    exercise.role = rule.role;
    exercise.points = rule.points;
    settings.course.exercises.push_back(exercise);
  }
  EXPECT_EQ(made_by(settings).exercises, three_exercises().exercises);
  settings.course.of_hand_in = {"S1"};
  const MadeBy week = made_by(settings);
  settings.course.exercises[1].points = 99;
  EXPECT_EQ(made_by(settings), week) << "S2 is another hand-in's";
  settings.course.exercises[0].points = 99;
  EXPECT_NE(made_by(settings), week);
}

TEST(MadeBy, TellsWhatDiffersAndTheWayOut) {
  MadeBy base = three_exercises();
  base.budget = {{"seconds", "20"}, {"starts", "6"}};
  base.partial = true;
  const std::string course = "use the course file that made it. ", other = "another course file: ";
  const struct {
    std::function<void(MadeBy& here)> change;
    std::string what, way;
  } rows[] = {
      {[](MadeBy&) {}, "", ""},
      {[](MadeBy& here) {
         here.exercises[1].points = 15;
         here.exercises[2] = {"H3", Role::absent, 0};
         here.exercises[3] = {"H4", Role::assigned, 5};
       },
       other + "S2 is worth 10 points there and 15 here, H3 is optional there and left out here, "
               "H4 is given there and assigned here. ",
       course},
      {[](MadeBy& here) { here.exercises.pop_back(); }, "", ""},  // an unknown exercise is left out
      {[](MadeBy& here) {
         here.exercises.push_back({"X1", Role::assigned, 1});
       },
       other + "X1 is left out there and assigned here. ", course},
      {[](MadeBy& here) {
         here.budget = {{"seconds", "30"}};
       },
       other +
           "the budget's seconds is 20 there and 30 here, the budget's starts is 6 there and not set here. ",
       course},
      {[](MadeBy& here) { here.partial = false; }, other + "\"partial\" is true there and false here. ",
       course},
      {[](MadeBy& here) { here.suite = "hash of another"; }, "*", "use the hairgrade that made it. "},
      {[](MadeBy& here) { here.secret = "hash of another"; },
       "another secret: its fingerprint is hash of a secret there and hash of another here. ",
       "use the secret that made it, with --secret or by hairgrade secret import. "},
      {[](MadeBy& here) { here.isolation = Isolation::none; }, "*", "leave out --unsafe-no-sandbox. "},
      {[](MadeBy& here) { here.isolation = Isolation::container; },
       "another sandbox: namespaces there and container here. ", "grade with --isolation namespaces. "},
      {[](MadeBy& here) { here.images = false; }, "*", "leave out --no-images. "},
  };
  for (const auto& [change, what, way] : rows) {
    MadeBy here = base;
    change(here);
    const Told found = told(base, here);
    EXPECT_EQ(what == "*" ? what : found.first, what);
    EXPECT_EQ(found.second, way);
  }
  MadeBy bare = base;
  bare.isolation = Isolation::none;
  bare.images = false;
  EXPECT_EQ(told(bare, base).second, "add --unsafe-no-sandbox. add --no-images. ");
}

TEST(MadeBy, SeesEverySettingThatChangesPoints) {
  const hair::TemporaryFolder folder("made-by");
  for (const char* file : {"kit", "suite", "scenes"}) std::ofstream(folder.path() / file) << file;
  GradingSettings settings;
  settings.course.exercises.resize(2);
  settings.course.exercises[0].id = "S1";
  settings.course.exercises[0].points = 32;
  settings.course.exercises[1].id = "S2";
  settings.course.exercises[1].role = Role::given;
  settings.kit = folder.path() / "kit";
  settings.suite = folder.path() / "suite";
  settings.scenes = folder.path() / "scenes";
  settings.secret = "a secret for this test";
  const MadeBy first = made_by(settings);
  EXPECT_EQ(first, made_by(settings));

  const auto differs = [&](auto change) {
    GradingSettings other = settings;
    change(other);
    return differences(first, made_by(other)).size();
  };
  EXPECT_EQ(differs([](auto& s) { s.course.exercises[0].points = 33; }), 1U);
  EXPECT_EQ(differs([](auto& s) { s.course.exercises[0].role = Role::optional; }), 1U);
  EXPECT_EQ(differs([](auto& s) { s.course.exercises[1].role = Role::absent; }), 1U);
  EXPECT_EQ(differs([](auto& s) { s.course.exercises[1].points = 33; }), 0U) << "nobody is asked for it";
  EXPECT_EQ(differs([](auto& s) { s.course.partial = true; }), 1U);
  EXPECT_EQ(differs([](auto& s) { s.isolation = Isolation::none; }), 1U);
  EXPECT_EQ(differs([](auto& s) { s.images = false; }), 1U);
  EXPECT_EQ(differs([](auto& s) { s.secret += "."; }), 1U);
  EXPECT_EQ(differs([](auto& s) { s.exercise = "S1"; }), 0U);
  EXPECT_EQ(differs([](auto& s) { s.study = true; }), 0U);
  for (const char* file : {"kit", "suite", "scenes"}) {
    std::ofstream(folder.path() / file) << file << " with a bug that is fixed";
    EXPECT_EQ(differs([](auto&) {}), 1U) << file;
    std::ofstream(folder.path() / file) << file;
  }
  EXPECT_EQ(to_json(first).find(settings.secret), std::string::npos);
}

}  // namespace
}  // namespace grader::grading
