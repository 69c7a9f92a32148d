// STAFF ONLY.
#include "grader/suite/end_to_end.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "grader/suite/trial.h"
#include "hair/runs.h"

namespace grader {
namespace {

constexpr std::uint64_t kMostFrames = 10000;
// Two ways to add the same numbers are apart by rounding, which a swinging strand makes larger; what is below
// this nobody sees.
constexpr double kSame = 1e-3;

// What a worker's server wrote: see grader/worker/serve_runs.cpp.
hair::RunResult get_run(MessageReader& reply, const hair::Run& run) {
  std::size_t size = 0;
  for (const int particles : run.strands) size += 3 * static_cast<std::size_t>(particles);
  hair::RunResult result;
  result.trouble = reply.get_text();
  const auto frames = reply.get<std::uint64_t>();
  if (frames > kMostFrames) throw MalformedMessage("too many frames");
  for (std::uint64_t i = 0; i < frames; ++i) {
    hair::Frame frame;
    frame.time = reply.get<double>();
    for (Eigen::VectorXd* part : {&frame.state.x, &frame.state.v}) {
      const std::vector<double> values = reply.get_doubles(size);
      *part = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(size));
    }
    frame.stretch = reply.get<double>();
    frame.energy = reply.get<double>();
    result.frames.push_back(std::move(frame));
  }
  reply.expect_end();
  return result;
}

// The diagonal of the box that holds all particles in all frames.
double extent(const hair::RunResult& run) {
  Eigen::Array3d low = Eigen::Array3d::Constant(INFINITY), high = -low;
  for (const hair::Frame& frame : run.frames)
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

Difference compare(const hair::RunResult& theirs, const hair::RunResult& ours) {
  Difference difference;
  const double size = extent(ours);
  for (std::size_t i = 0; i < std::min(theirs.frames.size(), ours.frames.size()); ++i) {
    const hair::Frame &a = theirs.frames[i], &b = ours.frames[i];
    double distance = 0;
    for (Eigen::Index j = 0; j < a.state.x.size(); j += 3)
      distance = std::max(distance, (a.state.x.segment<3>(j) - b.state.x.segment<3>(j)).norm() / size);
    if (distance > difference.distance) {
      difference.distance = distance;
      difference.at = b.time;
    }
    if (distance > kSame && difference.first < 0) difference.first = b.time;
    difference.stretch = std::max(difference.stretch, a.stretch);
    difference.our_stretch = std::max(difference.our_stretch, b.stretch);
    difference.energy = a.energy;
    difference.our_energy = b.energy;
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

std::string numbers(const hair::RunResult& theirs, const Difference& difference) {
  std::ostringstream text;
  text << "largest distance " << difference.distance << " of the scene's size, at " << seconds(difference.at)
       << "; largest stretch " << difference.stretch << ", the reference's " << difference.our_stretch
       << "; energy in the end " << difference.energy << " J, the reference's " << difference.our_energy
       << " J; " << theirs.frames.size() << " frames";
  return text.str();
}

bool all_finite(const hair::RunResult& run) {
  return std::all_of(run.frames.begin(), run.frames.end(), [](const hair::Frame& frame) {
    return frame.state.x.allFinite() && frame.state.v.allFinite() && std::isfinite(frame.stretch) &&
           std::isfinite(frame.energy);
  });
}

void judge(RunResult& result, const hair::RunResult& theirs, const hair::RunResult& ours) {
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

void run_scene(Student& student, const hair::Run& run, RunResult& result) {
  try {
    Trial trial(student, Random("", run.name));
    trial.describe(run.name);
    MessageWriter request;
    request.put(run.name);
    MessageReader reply = trial.ask(request, [](int, const auto&, auto&) -> bool {
      throw MalformedMessage("a product that nobody asked for");
    });
    judge(result, get_run(reply, run), hair::do_run(run.name));
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
  for (const hair::Run& run : hair::runs()) {
    const auto calls = [&](const auto& ids) {
      return std::any_of(run.exercises.begin(), run.exercises.end(),
                         [&](const std::string& id) { return ids.count(id) > 0; });
    };
    if (calls(exercises.left_out)) continue;
    RunResult result{run.name, run.shows, RunOutcome::not_run, "", ""};
    if (calls(exercises.unavailable)) {
      for (const std::string& id : run.exercises)
        if (const auto why = exercises.unavailable.find(id); why != exercises.unavailable.end())
          result.feedback += (result.feedback.empty() ? "" : ", ") + id + " " + why->second;
      result.feedback += ".";
    } else {
      run_scene(student, run, result);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace grader
