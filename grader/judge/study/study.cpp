// STAFF ONLY. Runs a submission's methods and the reference's in turn, and compares error and time.
#include "grader/judge/study/study.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "hair/io/plot/work_precision.h"
#include "solver/timing.h"

namespace grader::inline judge {
namespace {

constexpr int kMostTimes = 500;

// Holds the student's or the reference's runs of one part.
struct Side {
  struct Run {
    TimeGrid grid;
    StudyPoint point;
    double seconds = 0;  // is the time of one run, and determines the repetitions
  };
  Runner& runner;
  bool is_student;
  std::vector<Run> runs = {};
  double seconds = 0;  // is the sum so far
  bool over = false;   // gets no more runs
};

// Compares a motion with the true one, or notes that it ran away.
StudyPoint judged(const TimeGrid& grid, const Played& played, const Truth& truth) {
  StudyPoint point{.steps = grid.steps(),
                   .end = StudyEnd::ran_away,
                   .solver_steps = played.solver_steps,
                   .correction_steps = played.correction_steps};
  const std::size_t stride = (truth.motion.states.size() - 1) / static_cast<std::size_t>(grid.frames);
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < played.frames.size(); ++k) {
    const particles::State& state = played.frames[k];
    const Eigen::VectorXd apart = state.x - truth.motion.states[k * stride].x;
    if (!apart.allFinite() || !state.v.allFinite()) {
      point.note = "numbers that are not finite";
      return point;
    }
    for (Eigen::Index at = 0; at < apart.size(); at += 3) {
      const double distance = apart.segment<3>(at).norm();
      if (!(distance <= truth.size)) {
        point.note = "further away than the motion is large";
        return point;
      }
      if (k == 0) continue;  // all motions start there
      sum += distance * distance;
      count += 1;
    }
  }
  if (!played.trouble.empty()) {
    point.note = "it broke off";
    return point;
  }
  if (played.frames.size() != static_cast<std::size_t>(grid.frames) + 1)
    throw MalformedMessage("a run with another number of frames");
  point.end = StudyEnd::finished;
  point.error = std::sqrt(sum / count);
  return point;
}

// True if the error falls from one run to the next as a method's does. Slower than that it stalls. What falls
// faster than the order allows is chance: a dip in which errors cancel.
bool falls(const StudyPoint& one, const StudyPoint& next, int order) {
  constexpr double kLeastOrder = 0.5;
  const double steps = static_cast<double>(next.steps) / one.steps;
  const double slope = std::log(one.error / next.error) / std::log(steps);
  return slope >= kLeastOrder && slope <= order + 1;
}

// Returns the finest runs, as far as the error falls from each to the next; none if it does not in the end.
// Before that, the steps are too long for the method's order to show.
std::vector<hair::Sample> samples_of(const PartStudy& part, const StudyCurve& curve, std::size_t round) {
  constexpr double kMeans = 10;  // times the least error: below that, rounding stalls
  std::vector<const StudyPoint*> finished;
  for (const StudyPoint& point : curve.points)
    if (point.end == StudyEnd::finished && round < point.seconds.size() &&
        (point.error > kMeans * part.least_error || finished.empty() ||
         finished.back()->error > kMeans * part.least_error))
      finished.push_back(&point);
  std::size_t first = finished.size();
  while (first > 0 && (first == finished.size() || falls(*finished[first - 1], *finished[first], part.order)))
    --first;
  std::vector<hair::Sample> samples;
  for (std::size_t i = first; i < finished.size(); ++i)
    samples.push_back({finished[i]->seconds[round], finished[i]->error});
  return samples.size() < 2 ? std::vector<hair::Sample>() : samples;
}

std::optional<TimeRatio> ratio_of(const PartStudy& part, const StudyCurve& curve) {
  std::vector<double> ratios;
  for (std::size_t at = 0; at < static_cast<std::size_t>(std::max(part.rounds, 1)); ++at)
    if (const auto ratio =
            time_ratio(samples_of(part, curve, at), samples_of(part, part.reference, at), part.least_error))
      ratios.push_back(*ratio);
  if (ratios.empty()) return {};
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  return TimeRatio{timing::median(ratios), *least, *most};
}

using Sides = std::array<Side*, 3>;  // the student's, ours, ours again

class PartStudied {
 public:
  PartStudied(const StudiedPart& part, const Truth& truth, const StudySettings& settings, const Asked& asked)
      : part_(part), truth_(truth), settings_(settings), asked_(asked) {}

  PartStudy study(Runner& student, Runner& reference, Runner& twin) {
    Side theirs{student, true}, ours{reference, false}, ours_again{twin, false};
    const Sides sides = {&theirs, &ours, &ours_again};
    const TimeGrid own{part_.scene.frames, part_.scene.steps_per_frame};
    for (Side* side : sides) ask(*side, own, 1);  // warms up
    for (const TimeGrid& grid : grids_of(part_.scene))
      for (Side* side : sides) play_first(*side, grid);
    // A short run is repeated, so that its time exceeds that of a request. The reference decides how often,
    // after as many repetitions as its first time suggests.
    for (Side::Run& run : ours.runs)
      if (run.point.end == StudyEnd::finished) ask(ours, run.grid, times_of(run), &run.seconds);

    PartStudy result;
    result.rounds = measure_rounds(sides);
    result.name = part_.name;
    result.duration = part_.scene.frames / part_.scene.frames_per_second;
    result.own_steps = own.steps();
    result.order = part_.order;
    result.truth = truth_.motion.method;
    result.least_error = truth_.motion.least_error();
    result.student = curve_of(theirs);
    result.reference = curve_of(ours);
    result.ratio = ratio_of(result, result.student);
    result.noise = ratio_of(result, curve_of(ours_again, false));
    result.note = note_;
    return result;
  }

 private:
  // Returns nothing if the answer is bad or the side gets no more runs; `seconds` is then useless.
  std::optional<StudyPoint> ask(Side& side, const TimeGrid& grid, int times, double* seconds = nullptr) {
    if (side.over) return {};
    if (asked_) asked_(side.is_student, grid.steps());
    const SceneText text = on_grid(part_, grid);
    std::string why;
    try {
      const Play play = side.runner.play(text, hair::parse_scene(text.json, text.name), times);
      StudyPoint point = judged(grid, play.played, truth_);
      const double taken = play.seconds.value_or(0);
      if (seconds != nullptr) *seconds = taken / times;
      charge(side, taken);
      return point;
    } catch (const CaseFailed& failure) {
      why = failure.feedback;
    } catch (const MalformedMessage&) {
      why = "the code sent the grader a message that does not fit the request";
    }
    if (!side.is_student) throw std::runtime_error("the reference does not play " + part_.name + ": " + why);
    side.over = true;
    note_ = "In " + std::to_string(grid.steps()) + " steps: " + why + ". What comes after that is left out.";
    return {};
  }

  void charge(Side& side, double seconds) {
    side.seconds += seconds;
    if (!side.is_student || side.seconds <= settings_.most_seconds) return;
    side.over = true;
    note_ = "Your code took more CPU time than a study has. What comes after that is left out.";
  }

  void play_first(Side& side, const TimeGrid& grid) {
    if (side.over) return;
    Side::Run run{grid, {.steps = grid.steps(), .end = StudyEnd::broke, .note = "no answer"}};
    if (const auto point = ask(side, grid, 1, &run.seconds)) {
      run.point = *point;
      run.point.first_seconds = run.seconds;
    }
    side.runs.push_back(std::move(run));
  }

  // Returns the number of complete rounds. Both sides keep the times of complete rounds only, so that each
  // run has as many; without any they keep the times of the first runs.
  int measure_rounds(const Sides& sides) {
    int whole = 0;
    while (whole < settings_.rounds && !sides[0]->over && round(sides, whole)) ++whole;
    for (Side* side : sides)
      for (Side::Run& run : side->runs) {
        StudyPoint& point = run.point;
        if (point.end != StudyEnd::finished) continue;
        point.seconds.resize(static_cast<std::size_t>(whole));
        if (whole == 0 && point.first_seconds > 0) point.seconds = {point.first_seconds};
      }
    return whole;
  }

  // Each side is first in every third round.
  bool round(const Sides& sides, std::size_t number) {
    for (std::size_t i = 0; i < sides[1]->runs.size(); ++i) {
      const int times = times_of(sides[1]->runs[i]);
      for (std::size_t turn = 0; turn < sides.size(); ++turn)
        if (!measure(*sides[(number + turn) % sides.size()], i, times)) return false;
    }
    return true;
  }

  // False if a run that should have a time has none.
  bool measure(Side& side, std::size_t i, int times) {
    if (i >= side.runs.size() || side.runs[i].point.end != StudyEnd::finished) return true;
    StudyPoint& point = side.runs[i].point;
    double seconds = 0;
    const std::optional<StudyPoint> again = ask(side, side.runs[i].grid, times, &seconds);
    if (!again) return false;
    if (again->end != StudyEnd::finished || again->error != point.error) {
      if (!side.is_student)
        throw std::runtime_error("the reference does not play " + part_.name + " twice alike");
      point.end = StudyEnd::broke;
      point.note = "asked for again, it moved otherwise";
      point.seconds.clear();
      return true;
    }
    point.seconds.push_back(seconds);
    return seconds > 0;
  }

  int times_of(const Side::Run& ours) const {
    if (!(ours.seconds > 0)) return 1;
    const double times = std::ceil(settings_.least_seconds / ours.seconds);
    return static_cast<int>(std::clamp(times, 1.0, static_cast<double>(kMostTimes)));
  }

  StudyCurve curve_of(Side& side, bool with_boundary = true) {
    StudyCurve curve;
    // A run that broke off decides nothing.
    const Side::Run *stable = nullptr, *unstable = nullptr;
    for (auto run = side.runs.rbegin(); run != side.runs.rend() && unstable == nullptr; ++run) {
      if (run->point.end == StudyEnd::finished) stable = &*run;
      if (run->point.end == StudyEnd::ran_away) unstable = &*run;
    }
    if (stable != nullptr) {
      curve.stable_steps = stable->point.steps;
      curve.stable_everywhere = unstable == nullptr;
      if (unstable != nullptr && with_boundary)
        curve.stable_steps = boundary(side, unstable->grid, curve.stable_steps);
    }
    for (Side::Run& run : side.runs) curve.points.push_back(std::move(run.point));
    return curve;
  }

  // Finds by bisection the fewest steps that are stable, between an unstable grid and `stable`.
  int boundary(Side& side, const TimeGrid& unstable, int stable) {
    const std::vector<TimeGrid> inside = between(unstable);
    std::size_t low = 0, high = inside.size();  // inside[high] is stable, or beyond the end
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      const std::optional<StudyPoint> point = ask(side, inside[middle], 1);
      if (!point) break;
      if (point->end == StudyEnd::finished)
        high = middle;
      else
        low = middle + 1;
    }
    return high < inside.size() ? inside[high].steps() : stable;
  }

  const StudiedPart& part_;
  const Truth& truth_;
  const StudySettings& settings_;
  const Asked& asked_;
  std::string note_;
};

}  // namespace

PartStudy study_part(const StudiedPart& part, const Truth& truth, Runner& student, Runner& reference,
                     Runner& twin, const StudySettings& settings, const Asked& asked) {
  return PartStudied(part, truth, settings, asked).study(student, reference, twin);
}

Play WorkerRunner::play(const SceneText& text, const hair::Scene& scene, int times) {
  Trial trial(student_, Random("", text.name));
  trial.describe(text.name);
  Play play;
  play.played = play_elsewhere(trial, text.json, scene, times);
  const double now = student_.worker_cpu_seconds().value_or(0);
  if (starts_ == student_.starts() && now > clock_) play.seconds = now - clock_;
  starts_ = student_.starts();
  clock_ = now;
  return play;
}

Play UntilItGivesUp::play(const SceneText& text, const hair::Scene& scene, int times) {
  using Clock = std::chrono::steady_clock;
  if (wall_left_ <= 0 && !end_)
    end_ = CaseFailed{Status::timed_out, "the code takes too long by the clock on the wall", ""};
  if (end_) throw CaseFailed(*end_);
  struct Charge {
    double& left;
    Clock::time_point start = Clock::now();
    ~Charge() { left -= std::chrono::duration<double>(Clock::now() - start).count(); }
  } charge{wall_left_};
  try {
    return runner_.play(text, scene, times);
  } catch (const CaseFailed& failure) {
    crashes_ += failure.status == Status::crashed;
    if (failure.status == Status::timed_out || failure.status == Status::broke_rules ||
        crashes_ >= kMostCrashes)
      end_ = failure;
    throw;
  }
}

}  // namespace grader::judge
