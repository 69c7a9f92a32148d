// STAFF ONLY. Makes synthetic results of a class for tests.
#include "grader/report/facts/sample_results.h"

#include <gtest/gtest.h>

#include <array>

#include "grader/compare/compare.h"
#include "grader/compare/montage.h"
#include "grader/compare/test_pictures.h"
#include "hair/io/image/png.h"
#include "hair/view/motion.h"

namespace grader::inline report {
namespace {

constexpr int kUnreadable = 14;  // numbers the submission that can't be read
constexpr int kNotTaken = 15;    // numbers one whose second file is not taken

constexpr std::array<const char*, 6> categories{"The lecture's examples",  "Known matrices",
                                                "Ill-conditioned systems", "Clustered eigenvalues",
                                                "The step limit",          "Scaling"};

bool runs(Status status) {
  return status != Status::missing && status != Status::not_implemented &&
         status != Status::does_not_compile && status != Status::not_taken && status != Status::unreadable;
}

ExerciseResult exercise(const char* id, const char* title, const char* file, double max_points, Status status,
                        int seed) {
  ExerciseResult result{.id = id,
                        .title = title,
                        .file = file,
                        .status = status,
                        .max_points = max_points,
                        .feedback = sentence_for(status)};
  if (status == Status::does_not_compile) {
    result.compiler_messages = std::string(file) +
                               ":12:14: error: 'dott' was not declared in this scope; did you mean 'dot'?\n"
                               "   12 |   rr = dott(r, r);\n      |        ^~~~";
    result.staff_log = "g++ ended with code 1";
  }
  if (!runs(status)) return result;
  const double share = max_points / static_cast<double>(categories.size());
  for (std::size_t i = 0; i < categories.size(); ++i) {
    const bool right =
        status == Status::passed ||
        (status != Status::wrong && (static_cast<int>(i) * 7 + seed) % 6 < 4 && i + 1 < categories.size());
    const Status one = right ? Status::passed : status == Status::partly ? Status::wrong : status;
    result.cases.push_back({categories[i], one, right ? share : 0, share,
                            right ? "All 12 cases are right."
                                  : "3 of 12 cases: the residual is 10 to 100 times larger than asked for.",
                            right ? "" : "case 7: n = 100, seed 0x5eed, expected <= 1e-20, got 3.1e-19"});
    result.points += right ? share : 0;
  }
  if (status == Status::crashed)
    result.staff_log = "worker ended by signal 11 in case 7; started again (1 of 5)";
  return result;
}

}  // namespace

PictureResult sample_picture(const std::string& name, int shift) {
  constexpr int kWidth = 160, kHeight = 90;
  const hair::Image student = strands(kWidth, kHeight, 20, shift), reference = strands(kWidth, kHeight, 20);
  const ErrorMap map = flip(reference, student);
  const PictureDistance distance = compare_pictures(reference, student, map);
  return {name,
          distance.blurred_rmse,
          distance.flip_mean,
          hair::encode_png(student),
          hair::encode_png(reference),
          distance.identical ? "" : hair::encode_png(heat_map(map))};
}

RunMotions sample_motions(double off) {
  constexpr int kFrames = 10;
  const auto motion = [](double shift) {
    hair::MotionFrames frames(kFrames);
    hair::MotionStory story;
    story.shows = "strands that sway";
    for (int k = 0; k < kFrames; ++k) {
      hair::Drawing drawing;
      drawing.strands.sizes = {2, 2};
      for (const double x : {0.0, 0.5}) {
        const double aside = x + 0.02 * k + (k < kFrames / 2 ? 0 : shift);
        drawing.strands.points.insert(drawing.strands.points.end(), {{x, 0, 1}, {aside, 0, 0}});
      }
      frames.add(drawing);
      story.times.push_back(0.1 * k);
    }
    story.camera = {.eye = {0.25, -3, 0.5}, .target = {0.25, 0, 0.5}};
    return frames.json(story);
  };
  return {motion(off), motion(0), {}};
}

std::vector<SubmissionResult> sample_class(int size) {
  constexpr std::array<const char*, 10> names{"alice",  "bob",   "carol", "dave", "erin",
                                              "faythe", "grace", "heidi", "ivan", "judy"};
  const std::array<PictureResult, 3> pictures{sample_picture("0.50 s", 0), sample_picture("0.50 s", 1),
                                              sample_picture("0.50 s", 30)};
  std::vector<SubmissionResult> results;
  for (int i = 0; i < size; ++i) {
    SubmissionResult result;
    result.name =
        std::string(names[static_cast<std::size_t>(i % 10)]) + (i < 10 ? "" : "_" + std::to_string(i / 10));
    result.fingerprint = "0123456789abcdef0123456789abcdef";
    Status first = i % 3 == 2 ? all_statuses[0] : all_statuses[(i + i / 10) % 10];
    Status second = i % 2 == 1 ? all_statuses[1] : all_statuses[(i * 3 + i / 10) % 10];
    Status third = all_statuses[i % 10];
    if (i == kUnreadable) first = second = third = Status::unreadable;
    if (i == kNotTaken) second = Status::not_taken;
    result.exercises.push_back(exercise("S1", "Conjugate gradients", "conj_grad.cpp", 30, first, i));
    result.exercises.push_back(exercise("S2", "Normal equations", "normal_equations.cpp", 20, second, i + 1));
    result.exercises.push_back(
        exercise("P1", "Explicit integrators", "explicit_integrators.cpp", 5, third, i + 2));
    result.exercises.back().extra_credit = true;
    for (ExerciseResult& one : result.exercises)
      if (runs(one.status)) {
        one.pictures.assign(3, pictures[one.status == Status::passed   ? 0
                                        : one.status == Status::partly ? 1
                                                                       : 2]);
        one.pictures[1].name = "1.00 s";
        one.pictures[2].name = "2.00 s";
      }
    if (i == kUnreadable) {
      result.note =
          "handin.tar.gz can't be read: it is damaged or cut short. Pack it again, and check that it opens.";
    }
    results.push_back(result);
  }
  return results;
}

std::vector<SubmissionResult> class_of_ten_exercises(int size) {
  struct Made {
    const char *id, *title, *file;
    double points;
  };
  constexpr std::array<Made, 7> more{{{"P2", "Constraint forces", "constraint_forces.cpp", 15},
                                      {"H1", "Stretch springs", "stretch_springs.cpp", 15},
                                      {"H2", "Angular springs", "angular_springs.cpp", 25},
                                      {"H3", "Bend springs", "bend_springs.cpp", 10},
                                      {"H4", "Linearly implicit Euler", "implicit_euler.cpp", 25},
                                      {"H5", "Length correction", "length_correction.cpp", 20},
                                      {"H6", "Predictor-corrector", "predictor_corrector.cpp", 20}}};
  std::vector<SubmissionResult> results = sample_class(size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < static_cast<int>(more.size()); ++j) {
      const Made& one = more[static_cast<std::size_t>(j)];
      Status status = (i + j) % 3 == 0 ? Status::passed : all_statuses[(i * 3 + j * 7) % 10];
      if (i == kUnreadable) status = Status::unreadable;
      std::vector<ExerciseResult>& exercises = results[static_cast<std::size_t>(i)].exercises;
      exercises.push_back(exercise(one.id, one.title, one.file, one.points, status, i + j));
      exercises.back().extra_credit = j == 0 || j == 3;
    }
  return results;
}

std::vector<SubmissionResult> class_with_decisions() {
  std::vector<SubmissionResult> results = sample_class(4);
  const auto excuse = [](ExerciseResult& one) {
    one.status = Status::excused;
    one.points = one.max_points = 0;
  };
  const auto set = [](ExerciseResult& one, double points) {
    one.points = points;
    one.points_set = true;
  };
  excuse(results[0].exercises[2]);
  set(results[1].exercises[0], 20);
  set(results[2].exercises[1], 16);
  for (ExerciseResult& one : results[3].exercises) excuse(one);
  results[0].decided = {{"P1", "excuse", "excuse P1: ill", ""}};
  results[1].decided = {{"S1.2", "points", "points S1.2: 10 (computed: 5): <b>", ""},
                        {"", "comment", "comment: well done", ""}};
  results[2].decided = {{"S2", "points", "points S2: 16", "ada set S2 to 16, and now it is 10"}};
  results[3].decided = {{"", "excuse", "excuse: ill", ""}};
  return results;
}

SubmissionResult submission_full_of(const std::string& text) {
  ExerciseResult exercise{.id = "S1",
                          .status = Status::wrong,
                          .max_points = 10,
                          .cases = {{text, Status::wrong, 0, 10, text, text}},
                          .pictures = {{text, 1, 1, text, text, text}}};
  exercise.title = exercise.file = exercise.feedback = exercise.compiler_messages = exercise.staff_log = text;
  return {.name = "mallory", .exercises = {exercise}, .note = text, .fingerprint = "00ff"};
}

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++found;
  return found;
}

void expect_in_order(const std::string& text, const std::vector<std::string>& parts) {
  std::size_t at = 0;
  for (const std::string& part : parts) {
    const std::size_t found = text.find(part, at);
    ASSERT_NE(found, std::string::npos) << "no \"" << part << "\" after \"" << text.substr(at, 200) << "\"";
    at = found + part.size();
  }
}

}  // namespace grader::report
