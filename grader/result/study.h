// STAFF ONLY. The results of a study of a submission, as plain data: error against time for each scene,
// compared with the reference in an identical worker. Shown, but not scored: only study.html and study.json
// contain it.
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

// A motion with a given number of steps.
struct StudyPoint {
  int steps = 0;  // from the start to the end
  StudyEnd end = StudyEnd::broke;
  std::string note = {};  // why it did not finish

  // Only if it finished.
  double error = 0;  // m, the root mean square of the particles' distances from the true positions
  std::int64_t solver_steps = 0;      // of ConjGrad; the worker reports this and the next number
  std::int64_t correction_steps = 0;  // of the length correction
  // CPU time, s. If no round was measured, `seconds` has only the time of the first play.
  double first_seconds = 0;          // of its first play; 0: unknown
  std::vector<double> seconds = {};  // of each measured round

  bool operator==(const StudyPoint&) const = default;
};

struct StudyCurve {
  std::vector<StudyPoint> points;  // by their steps, coarsest first

  // The smallest number of steps such that the motion runs away neither with it nor with any larger number
  // that was played; 0: there is none. Points that broke don't count.
  int stable_steps = 0;
  bool stable_everywhere = false;  // true: stable with the smallest number that was played

  bool operator==(const StudyCurve&) const = default;
};

// The student's time over the reference's for the same error: the median, and the smallest and largest of all
// rounds.
struct TimeRatio {
  double median = 1, least = 1, most = 1;

  bool operator==(const TimeRatio&) const = default;
};

// The subject of a pair of curves: a scene, or one toy of it.
struct PartStudy {
  std::string name;        // "pendulums, forward Euler"
  double duration = 0;     // s
  int own_steps = 0;       // the scene's own number
  int order = 1;           // of the method, for smooth motions
  std::string truth;       // the source of the true motion: "CVODE 6.4.1 ..."
  double least_error = 0;  // m: smaller errors are meaningless
  int rounds = 0;          // number of complete rounds; 0: times are of first plays
  StudyCurve student, reference;

  std::optional<TimeRatio> ratio;  // nothing if the two have no common error
  std::string note = {};           // omissions and their reasons

  bool operator==(const PartStudy&) const = default;
};

struct SceneStudy {
  std::string name, shows;
  std::string left_out = {};  // not empty: the reason why there are no parts
  std::vector<PartStudy> parts = {};

  bool operator==(const SceneStudy&) const = default;
};

struct SubmissionStudy {
  std::vector<SceneStudy> scenes;
  double student_seconds = 0, reference_seconds = 0;  // CPU time of the two workers

  bool operator==(const SubmissionStudy&) const = default;
};

double step_of(const PartStudy& part, int steps);  // s

}  // namespace grader::result
