// STAFF ONLY. What a study of a submission found, as plain data: error against time of each end-to-end scene, beside
// the reference in an identical worker. Shown, and not scored: no result and no page but study.html has any of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace grader {

enum class StudyEnd {
  finished,
  ran_away,  // further from where it should be than the motion is large, or not finite
  broke,     // the code ended, or did not answer as it should
};

std::string to_string(StudyEnd end);  // "ran away"

// A motion with one number of steps.
struct StudyPoint {
  int steps = 0;  // from the beginning to the end
  StudyEnd end = StudyEnd::broke;
  std::string note = {};  // why it did not finish

  // If it finished.
  double error = 0;  // m, the root mean square of the particles' distances from where they should be
  std::int64_t solver_steps = 0;      // of ConjGrad; these two as the worker says
  std::int64_t correction_steps = 0;  // of the length correction
  // CPU time, s. Without a measured round, `seconds` is the first play's.
  double first_seconds = 0;          // of its first play; 0: not known
  std::vector<double> seconds = {};  // of each round that was measured
};

struct StudyCurve {
  std::vector<StudyPoint> points;  // by their steps, coarsest first

  // The fewest steps with which the motion does not run away, and neither does it with any larger number that was
  // played; 0: there is none. Points that broke say nothing of it.
  int stable_steps = 0;
  bool stable_everywhere = false;  // fewer were not played
};

// What one pair of curves is about: a scene, or one toy of it.
struct PartStudy {
  std::string name;        // "pendulums, forward Euler"
  double duration = 0;     // s
  int own_steps = 0;       // of the scene as it is
  int order = 1;           // of the method, where it is smooth
  std::string truth;       // what errors are against: "CVODE 6.4.1 ..."
  double least_error = 0;  // m: what is below says nothing
  int rounds = 0;          // that were measured to their end; 0: times are of first plays
  StudyCurve student, reference;

  // How many times the reference's time the student's code takes for the same error: a median, and the least and the
  // largest of all rounds. Nothing where no error is reached by both.
  struct Ratio {
    double median = 1, least = 1, most = 1;
  };
  std::optional<Ratio> ratio;
  std::string note = {};  // what was left out, and why
};

struct SceneStudy {
  std::string name, shows;
  std::string left_out = {};  // not empty: why there are no parts
  std::vector<PartStudy> parts = {};
};

struct SubmissionStudy {
  std::vector<SceneStudy> scenes;
  double student_seconds = 0, reference_seconds = 0;  // of CPU time, of both workers
};

double step_of(const PartStudy& part, int steps);  // s

}  // namespace grader
