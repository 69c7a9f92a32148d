// STAFF ONLY.
#include "grader/suite/end_to_end.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "grader/suite/end_to_end_scenes.h"
#include "grader/suite/trial.h"
#include "hair/scene/playback.h"

namespace grader {
namespace {

// Two ways to add the same numbers are apart by rounding, which a swinging strand makes larger; what is below
// this nobody sees.
constexpr double kSame = 1e-3;

struct Frame {
  double time;  // s
  particles::State state;
  hair::FrameMeasures measures;
};

// A scene as it was played: its frames until the end, or until it broke.
struct Play {
  std::vector<Frame> frames;
  std::string trouble;  // empty, or where it broke
};

Frame frame_of(const hair::Playback& playback, double time, particles::State state) {
  const hair::FrameMeasures measures = playback.measure(state);
  return {time, std::move(state), measures};
}

Play play(const hair::Scene& scene) {
  hair::Playback playback(scene);
  Play play{{frame_of(playback, 0, playback.state())}, ""};
  for (int k = 0; k < scene.frames && play.trouble.empty(); ++k) {
    play.trouble = playback.advance().value_or("");
    if (play.trouble.empty()) play.frames.push_back(frame_of(playback, playback.time(), playback.state()));
  }
  return play;
}

// What a worker's server wrote: see grader/worker/serve_runs.cpp. Stretch and energy are the reference's of
// those states.
Play get_play(MessageReader& reply, const hair::Scene& scene) {
  const hair::Playback start(scene);
  const auto size = static_cast<std::size_t>(start.state().x.size());
  Play play;
  play.trouble = reply.get_text();
  const auto frames = reply.get<std::uint64_t>();
  if (frames > static_cast<std::uint64_t>(scene.frames) + 1) throw MalformedMessage("too many frames");
  for (std::uint64_t i = 0; i < frames; ++i) {
    const double time = reply.get<double>();
    particles::State state;
    for (Eigen::VectorXd* part : {&state.x, &state.v}) {
      const std::vector<double> values = reply.get_doubles(size);
      *part = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(size));
    }
    play.frames.push_back(frame_of(start, time, std::move(state)));
  }
  reply.expect_end();
  return play;
}

// The diagonal of the box that holds all particles in all frames.
double extent(const Play& run) {
  Eigen::Array3d low = Eigen::Array3d::Constant(INFINITY), high = -low;
  for (const Frame& frame : run.frames)
    for (Eigen::Index i = 0; i < frame.state.x.size(); i += 3) {
      low = low.min(frame.state.x.segment<3>(i).array());
      high = high.max(frame.state.x.segment<3>(i).array());
    }
  return (high - low).matrix().norm();
}

struct Difference {
  double distance = 0;                // the largest of a particle, relative to the scene's extent
  double at = 0;                      // s, where it is
  double first = -1;                  // s, where it first exceeds kSame; -1: nowhere
  double stretch = 0;                 // the largest of a segment
  double our_stretch = 0;             // the reference's
  double energy = 0, our_energy = 0;  // J, at the end
};

Difference compare(const Play& theirs, const Play& ours) {
  Difference difference;
  const double size = extent(ours);
  for (std::size_t i = 0; i < std::min(theirs.frames.size(), ours.frames.size()); ++i) {
    const Frame &a = theirs.frames[i], &b = ours.frames[i];
    double distance = 0;
    for (Eigen::Index j = 0; j < a.state.x.size(); j += 3)
      distance = std::max(distance, (a.state.x.segment<3>(j) - b.state.x.segment<3>(j)).norm() / size);
    if (distance > difference.distance) {
      difference.distance = distance;
      difference.at = b.time;
    }
    if (distance > kSame && difference.first < 0) difference.first = b.time;
    difference.stretch = std::max(difference.stretch, a.measures.stretch);
    difference.our_stretch = std::max(difference.our_stretch, b.measures.stretch);
    difference.energy = a.measures.energy();
    difference.our_energy = b.measures.energy();
  }
  return difference;
}

std::string seconds(double time) {
  std::ostringstream text;
  text.precision(3);
  text << time << " s";
  return text.str();
}

std::string lengths(const Difference& difference) {
  if (difference.stretch <= std::max(1e-6, 10 * difference.our_stretch)) return "";
  const char* band = difference.stretch < 1e-3   ? "up to 0.1 %"
                     : difference.stretch < 1e-2 ? "0.1 to 1 %"
                     : difference.stretch < 1e-1 ? "1 to 10 %"
                                                 : "more than 10 %";
  return std::string("; lengths are off by ") + band + ", ours by much less";
}

std::string numbers(const Play& theirs, const Difference& difference) {
  std::ostringstream text;
  text << "largest distance " << difference.distance << " of the scene's size, at " << seconds(difference.at)
       << "; largest stretch " << difference.stretch << ", the reference's " << difference.our_stretch
       << "; energy in the end " << difference.energy << " J, the reference's " << difference.our_energy
       << " J; " << theirs.frames.size() << " frames";
  return text.str();
}

bool all_finite(const Play& run) {
  return std::all_of(run.frames.begin(), run.frames.end(), [](const Frame& frame) {
    return frame.state.x.allFinite() && frame.state.v.allFinite() && std::isfinite(frame.measures.stretch) &&
           std::isfinite(frame.measures.energy());
  });
}

void judge(RunResult& result, const Play& theirs, const Play& ours) {
  const Difference difference = compare(theirs, ours);
  result.detail = numbers(theirs, difference);
  if (!all_finite(theirs)) {
    result.outcome = RunOutcome::blew_up;
    result.feedback = "Numbers that are not finite.";
  } else if (!theirs.trouble.empty()) {
    result.outcome = RunOutcome::blew_up;
    result.feedback = "Broke off after " + seconds(theirs.frames.empty() ? 0 : theirs.frames.back().time) +
                      ": " + theirs.trouble + ".";
  } else if (theirs.frames.size() != ours.frames.size()) {
    throw MalformedMessage("a run with another number of frames");
  } else if (difference.first < 0) {
    result.outcome = RunOutcome::same;
    result.feedback = "Moves like ours" + lengths(difference) + ".";
  } else {
    const char* band = difference.distance < 1e-2   ? "0.1 to 1 %"
                       : difference.distance < 1e-1 ? "1 to 10 %"
                                                    : "more than 10 %";
    result.outcome = RunOutcome::differs;
    result.feedback = std::string("Apart from ours by ") + band + " of the scene's size, noticeably from " +
                      seconds(difference.first) + " on" + lengths(difference) + ".";
  }
}

void run_scene(Student& student, const SceneText& text, const hair::Scene& scene, RunResult& result) {
  try {
    Trial trial(student, Random("", text.name));
    trial.describe(text.name);
    MessageWriter request;
    request.put(text.json);
    MessageReader reply = trial.ask(request, [](int, const auto&, auto&) -> bool {
      throw MalformedMessage("a product that nobody asked for");
    });
    judge(result, get_play(reply, scene), play(scene));
  } catch (const CaseFailed& failure) {
    const bool stub = failure.status == Status::not_implemented;
    result.outcome = stub ? RunOutcome::not_run : RunOutcome::failed;
    result.feedback = stub ? "A function that it calls is not implemented yet."
                           : to_string(failure.status) + ": " + failure.feedback;
    result.detail = failure.detail;
  } catch (const MalformedMessage& error) {
    result.outcome = RunOutcome::failed;
    result.feedback = "The code answered in a form that it has no business with.";
    result.detail = error.what();
  }
}

}  // namespace

std::vector<RunResult> run_end_to_end(Student& student, const AvailableExercises& exercises) {
  std::vector<RunResult> results;
  for (const SceneText& text : end_to_end_scenes()) {
    const hair::Scene scene = hair::parse_scene(text.json, text.name);
    const std::vector<std::string> called = hair::exercises_of(scene);
    const auto calls = [&](const auto& ids) {
      return std::any_of(called.begin(), called.end(),
                         [&](const std::string& id) { return ids.count(id) > 0; });
    };
    if (calls(exercises.left_out)) continue;
    RunResult result{text.name, scene.shows, RunOutcome::not_run, "", ""};
    if (calls(exercises.unavailable)) {
      for (const std::string& id : called)
        if (const auto why = exercises.unavailable.find(id); why != exercises.unavailable.end())
          result.feedback += (result.feedback.empty() ? "" : ", ") + id + " " + why->second;
      result.feedback += ".";
    } else {
      run_scene(student, text, scene, result);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace grader
