// STAFF ONLY. The results of a study of a submission, as plain data: error against time for each scene,
// compared with the reference in an identical worker. They are shown, but not scored: only study.html and
// study.json contain them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace grader::inline result {

enum class StudyEnd {
  finished,
  ran_away,  // the error is larger than the motion, or not finite
  broke,     // the code ended, or gave an invalid answer
};

std::string to_string(StudyEnd end);  // "ran away"

// This is a motion with a given number of steps.
struct StudyPoint {
  int steps = 0;  // from the start to the end
  StudyEnd end = StudyEnd::broke;
  std::string note = {};  // says why it did not finish

  // The following holds only for a motion that finished.
  double error = 0;  // m, the root mean square of the particles' distances from the true positions
  std::int64_t solver_steps = 0;      // ConjGrad's; the worker reports this and the next number
  std::int64_t correction_steps = 0;  // the length correction's
  // These are CPU times, s. If no round was measured, `seconds` has only the time of the first run.
  double first_seconds = 0;          // is that of its first run; 0: unknown
  std::vector<double> seconds = {};  // has one for each measured round

  bool operator==(const StudyPoint&) const = default;
};

struct StudyCurve {
  std::vector<StudyPoint> points;  // by their steps, coarsest first

  // This is the smallest number of steps from which on all measured motions are stable; 0: there is none.
  // Points that broke don't count.
  int stable_steps = 0;
  bool stable_everywhere = false;  // stable with the smallest number that was run

  bool operator==(const StudyCurve&) const = default;
};

// This is the student's time over the reference's for the same error: the median, and the smallest and
// largest of all rounds.
struct TimeRatio {
  double median = 1, least = 1, most = 1;

  bool operator==(const TimeRatio&) const = default;
};

// This is the subject of a pair of curves: a scene, or one toy of it.
struct PartStudy {
  std::string name;        // "pendulums, forward Euler"
  double duration = 0;     // s
  int own_steps = 0;       // is the scene's own number
  int order = 1;           // is the method's, for smooth motions
  std::string truth;       // names the source of the reference solution: "CVODE 6.4.1 ..."
  double least_error = 0;  // m: smaller errors are meaningless
  int rounds = 0;          // counts complete rounds; 0: times are of first runs
  StudyCurve student, reference;

  std::optional<TimeRatio> ratio;  // nothing if there is no error that both reach while they fall
  std::optional<TimeRatio> noise =
      {};                 // is the ratio of a second worker of the reference, in the same rounds
  std::string note = {};  // omissions and their reasons

  bool operator==(const PartStudy&) const = default;
};

struct SceneStudy {
  std::string name, shows;
  std::string left_out = {};                // not empty: the reason why there are no parts
  std::vector<std::string> exercises = {};  // "H4": those that it calls
  std::vector<PartStudy> parts = {};

  bool operator==(const SceneStudy&) const = default;
};

struct SubmissionStudy {
  std::vector<SceneStudy> scenes;
  double student_seconds = 0, reference_seconds = 0;  // CPU time of the two workers

  bool operator==(const SubmissionStudy&) const = default;
};

inline double step_of(const PartStudy& part, int steps) {  // s
  return part.duration / steps;
}

}  // namespace grader::result
