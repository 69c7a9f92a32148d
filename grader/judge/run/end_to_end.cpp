// STAFF ONLY.
#include "grader/judge/run/end_to_end.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "grader/judge/run/end_to_end_scenes.h"
#include "grader/judge/run/run_comparison.h"
#include "grader/judge/trial.h"

namespace grader {
namespace {

// Two ways to add the same numbers are apart by rounding, which a swinging strand makes larger; what is below
// this nobody sees.
constexpr double kSame = 1e-3;

struct Difference {
  double distance = 0;                // the largest of a particle, relative to the scene's extent
  double at = 0;                      // s, where it is
  double first = -1;                  // s, where it first exceeds kSame; -1: nowhere
  double stretch = 0;                 // the largest of a segment
  double our_stretch = 0;             // the reference's
  double energy = 0, our_energy = 0;  // J, at the end
};

Difference largest_difference(const RunComparison& run) {
  Difference difference;
  for (const Moment& moment : run.moments) {
    const double distance = moment.apart / run.size;
    if (distance > difference.distance) {
      difference.distance = distance;
      difference.at = moment.time;
    }
    if (distance > kSame && difference.first < 0) difference.first = moment.time;
    difference.stretch = std::max(difference.stretch, moment.theirs.stretch);
    difference.our_stretch = std::max(difference.our_stretch, moment.ours.stretch);
    difference.energy = moment.theirs.energy();
    difference.our_energy = moment.ours.energy();
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

std::string numbers(const Played& theirs, const Difference& difference) {
  std::ostringstream text;
  text << "largest distance " << difference.distance << " of the scene's size, at " << seconds(difference.at)
       << "; largest stretch " << difference.stretch << ", the reference's " << difference.our_stretch
       << "; energy in the end " << difference.energy << " J, the reference's " << difference.our_energy
       << " J; " << theirs.frames.size() << " frames";
  return text.str();
}

void judge(RunResult& result, const Played& theirs, const RunComparison& run, int frames) {
  const Difference difference = largest_difference(run);
  result.detail = numbers(theirs, difference);
  if (!run.finite) {
    result.outcome = RunOutcome::blew_up;
    result.feedback = "Numbers that are not finite.";
  } else if (!theirs.trouble.empty()) {
    result.outcome = RunOutcome::blew_up;
    result.feedback = "Broke off after " + seconds(run.moments.empty() ? 0 : run.moments.back().time) + ".";
    result.detail += "; the code says: " + theirs.trouble;
  } else if (theirs.frames.size() != static_cast<std::size_t>(frames) + 1) {
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

void run_scene(Student& student, const SceneText& text, const hair::Scene& scene,
               const std::optional<std::filesystem::path>& kept_pictures, RunResult& result) {
  try {
    Trial trial(student, Random("", text.name));
    trial.describe(text.name);
    const Played theirs = play_elsewhere(trial, text.json, scene);
    std::vector<int> pictures;
    constexpr int kParts = kRunPictures;
    for (int part = 1; part <= kParts; ++part) pictures.push_back(scene.frames * part / kParts);
    const RunComparison run = compare_runs(scene, pictures, theirs);
    judge(result, theirs, run, scene.frames);
    if (kept_pictures) result.pictures = draw_shots(run.shots, run.camera, *kept_pictures / text.name);
    // The scene is public, and the worker holds nothing of ours: students see all of it.
    for (PictureResult& picture : result.pictures) picture.far_off = false;
  } catch (const CaseFailed& failure) {
    const bool stub = failure.status == Status::not_implemented;
    result.outcome = stub ? RunOutcome::not_run : RunOutcome::failed;
    result.feedback = stub ? "A function that it calls is not implemented yet."
                           : to_string(failure.status) + ": " + failure.feedback + ".";
    result.detail = failure.detail;
  } catch (const MalformedMessage& error) {
    result.outcome = RunOutcome::failed;
    result.feedback = "The code answered in a form that it has no business with.";
    result.detail = error.what();
  }
}

}  // namespace

bool is_left_out(const hair::Scene& scene, const AvailableExercises& exercises) {
  const std::vector<std::string> called = hair::exercises_of(scene);
  return std::any_of(called.begin(), called.end(),
                     [&](const std::string& id) { return exercises.left_out.count(id) > 0; });
}

std::string why_not_run(const hair::Scene& scene, const AvailableExercises& exercises) {
  std::string all;
  for (const std::string& id : hair::exercises_of(scene))
    if (const auto why = exercises.unavailable.find(id); why != exercises.unavailable.end())
      all += (all.empty() ? "" : ", ") + id + " " + why->second;
  return all.empty() ? all : all + ".";
}

std::vector<RunResult> run_end_to_end(Student& student, const AvailableExercises& exercises,
                                      const std::optional<std::filesystem::path>& kept_pictures) {
  std::vector<RunResult> results;
  for (const SceneText& text : end_to_end_scenes()) {
    const hair::Scene scene = hair::parse_scene(text.json, text.name);
    if (is_left_out(scene, exercises)) continue;
    RunResult result{text.name, scene.shows, RunOutcome::not_run, why_not_run(scene, exercises), ""};
    if (result.feedback.empty()) run_scene(student, text, scene, kept_pictures, result);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace grader
