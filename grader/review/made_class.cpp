// STAFF ONLY. Makes up classes, the same each time.
#include "grader/review/made_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "grader/review/items.h"

namespace grader::inline review {
namespace {

constexpr std::array<const char*, 8> kCategories{
    "The lecture's examples", "Known matrices", "Ill-conditioned", "Extreme values", "Scaling",
    "Many particles",         "Random inputs",  kRunTitle};
constexpr std::array<const char*, 14> kExercises{"S1", "S2", "P1", "P2", "H1", "H2", "H3",
                                                 "H4", "H5", "H6", "H7", "H8", "H9", "H10"};
constexpr double kPoints = 2, kLimit = 1e-9;

constexpr std::array<const char*, 12> kFirst{"Ada",   "Ben",  "Chloé", "Đorđe", "Emil", "Fatima",
                                             "Gülay", "Hugo", "Ines",  "Jörg",  "Kai",  "Lea"};
constexpr std::array<const char*, 15> kLast{"Abel",  "Becker", "Conti", "Díaz",  "Ebner",
                                            "Fuchs", "Gruber", "Haas",  "Ito",   "Jansen",
                                            "Kühn",  "Lang",   "Moser", "Novák", "Öztürk"};

std::string name_of(std::size_t i) {
  const std::string number = std::to_string(i);
  return "p" + std::string(3 - std::min<std::size_t>(3, number.size()), '0') + number;
}

}  // namespace

ExerciseResult made_exercise(const std::string& id, const std::vector<Loss>& losses) {
  ExerciseResult exercise;
  exercise.id = id;
  exercise.title = "Exercise " + id;
  exercise.file = id + ".cpp";
  for (const char* title : kCategories)
    exercise.cases.push_back({title, Status::passed, kPoints, kPoints, "All cases are right.", ""});
  for (const Loss& loss : losses) {
    CaseResult& one = exercise.cases.at(loss.category - 1);
    one.status = loss.status;
    one.points = 0;
    one.feedback = "The error is larger than allowed.";
    std::ostringstream detail;
    if (loss.times > 0)
      detail << "n = 10, seed 17: the error of x: " << loss.times * kLimit << ", bound " << kLimit
             << "; worst entry 4: 0.035551177626964005, expected 0.03441942590869905";
    one.detail = detail.str();
    one.error_in_limits = std::isinf(loss.times) ? kNoNumber : loss.times;
  }
  exercise.max_points = kPoints * static_cast<double>(kCategories.size());
  exercise.points = exercise.max_points - kPoints * static_cast<double>(losses.size());
  exercise.status = losses.empty()        ? Status::passed
                    : exercise.points > 0 ? Status::partly
                                          : losses.front().status;
  exercise.feedback = sentence_for(exercise.status);
  return exercise;
}

ExerciseResult with_picture(ExerciseResult exercise, double flip, bool far_off) {
  for (const char* moment : {"0.50 s", "1.00 s", "2.00 s"})
    exercise.pictures.push_back({moment, flip, flip, "", "", "", far_off});
  return exercise;
}

SubmissionResult made_result(const std::string& name, std::vector<ExerciseResult> exercises) {
  SubmissionResult result;
  result.name = name;
  result.exercises = std::move(exercises);
  return result;
}

std::vector<Planted> put_made_class(Record& record, std::size_t size) {
  std::vector<HandIn> hand_ins;
  std::vector<Person> roster;
  std::vector<SubmissionResult> results;
  for (std::size_t i = 0; i < size; ++i) {
    Person person;
    person.name = std::string(kFirst[i % kFirst.size()]) + " " + kLast[i / kFirst.size() % kLast.size()];
    person.id(IdKind::id) = std::to_string(4711 + 13 * i);
    person.section = "Tutorial " + std::to_string(1 + i % 6);
    hand_ins.push_back({name_of(i), {.name = person.name, .id = person.id(IdKind::id)}, "canvas"});
    roster.push_back(person);
    std::vector<ExerciseResult> exercises;
    for (std::size_t j = 0; j < kExercises.size(); ++j) {
      // About a fifth has mistakes, each another one.
      std::vector<Loss> losses;
      const std::size_t draw = (i * 37 + j * 101 + i * j) % 97;
      if (draw < 20)
        for (std::size_t category = 1; category <= kCategories.size(); ++category)
          if ((draw * 7 + category * (i % 11 + 3) + j) % 4 == 0)
            losses.push_back({category, std::pow(10, 2 + draw % 9)});
      exercises.push_back(
          with_picture(made_exercise(kExercises[j], losses), losses.empty() ? 0 : 0.0001, false));
    }
    results.push_back(made_result(name_of(i), std::move(exercises)));
  }

  std::vector<Planted> planted;
  const auto plant = [&](std::size_t i, const ExerciseResult& exercise) {
    *std::ranges::find(results[i].exercises, exercise.id, &ExerciseResult::id) = exercise;
  };
  const auto expect = [&](ItemKind kind, const std::string& place, const std::string& person,
                          const std::string& right) {
    planted.push_back({word_of(kind) + "/" + place + "/" + person, right});
  };
  for (std::size_t i = 0; i < 6; ++i)
    plant(i, made_exercise("H2", {{3, 1.5 + 0.1 * static_cast<double>(i)}}));
  expect(ItemKind::near_threshold, "H2.3 up to 10 times the limit", "",
         "points for all: our limit is too strict");
  for (std::size_t i = 6; i < 10; ++i) plant(i, made_exercise("H4", {{2, 5e4}, {5, 3e8}}));
  expect(ItemKind::alike, "H4.2 1000 to a million times the limit, H4.5 more than a million times the limit",
         "", "a comment for all: one mistake, copied");
  results[10].note = "hand-in.rar can't be read: pack it as .zip";
  expect(ItemKind::not_taken, "", name_of(10), "ask for another archive");
  plant(11, made_exercise("S1", {{1, 0, Status::broke_rules}}));
  expect(ItemKind::broke_rules, "S1", name_of(11), "no points, and a talk");
  results[12].ended_by_the_clock = {"H7"};
  expect(ItemKind::not_final, "", name_of(12), "grade again");
  plant(13, made_exercise("H5", {{8, std::numeric_limits<double>::infinity()}}));
  expect(ItemKind::blown_up, "H5", name_of(13), "a comment on the step");
  plant(14, with_picture(made_exercise("H6", {{8, 50}}), 0.4, true));
  expect(ItemKind::far_in_pictures, "H6", name_of(14),
         "points for the run: the picture is wrong, not the code");
  plant(15, made_exercise("S2", {{2, 5e7}}));

  record.set_rules({.due = "2025-03-04 23:59", .late_per_cent_a_day = 10});
  record.put_people(hand_ins, roster);
  record.in_one([&] {
    for (std::size_t i = 0; i < size; ++i)
      record.put({results[i]}, {i == 16 ? "2025-03-05 00:20:00" : "2025-03-04 20:00:00", name_of(i)});
    record.decide(name_of(15), {DecisionKind::points, "S2.2", 1, 0, "nearly right"});
    plant(15, made_exercise("S2"));
    record.put({results[15]}, {"", name_of(15)});
    record.ask(name_of(17), "H1.2", "My springs are right, and the case has no rest length");
  });
  expect(ItemKind::near_threshold, "late", name_of(16), "20 minutes: free, or a day");
  expect(ItemKind::conflict, "S2.2", name_of(15), "full points: unset it");
  expect(ItemKind::request, "H1.2", name_of(17), "an answer");
  return planted;
}

}  // namespace grader::review
