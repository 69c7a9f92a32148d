// STAFF ONLY. Runs all parts of a submission's study.
#include "grader/judge/study/submission_study.h"

#include <algorithm>
#include <cmath>

#include "grader/judge/study/scenes.h"

namespace grader::inline judge {
namespace {

bool is_left_out(const hair::Scene& scene, const AvailableExercises& exercises) {
  return std::ranges::any_of(hair::exercises_of(scene),
                             [&](const std::string& id) { return exercises.left_out.contains(id); });
}

// Returns "H4 does not compile.", or an empty text.
std::string why_not_run(const hair::Scene& scene, const AvailableExercises& exercises) {
  std::string all;
  for (const std::string& id : hair::exercises_of(scene))
    if (const auto why = exercises.unavailable.find(id); why != exercises.unavailable.end())
      all += (all.empty() ? "" : ", ") + id + " " + why->second;
  return all.empty() ? all : all + ".";
}

}  // namespace

int study_cpu_seconds(const StudySettings& settings) {
  std::size_t parts = 0;
  for (const SceneText& text : studied_scenes()) parts += parts_of(text).size();
  return static_cast<int>(std::ceil(2 * settings.most_seconds * static_cast<double>(parts)));
}

SubmissionStudy study_submission(Student& student, Student& reference, const AvailableExercises& exercises,
                                 const std::optional<std::filesystem::path>& kept,
                                 const StudySettings& settings) {
  WorkerPlayer their_worker(student), ours(reference);
  UntilItGivesUp theirs(their_worker, settings.most_wall_seconds);
  SubmissionStudy study;
  for (const SceneText& text : studied_scenes()) {
    const hair::Scene scene = hair::parse_scene(text.json, text.name);
    if (is_left_out(scene, exercises)) continue;
    SceneStudy& one = study.scenes.emplace_back(SceneStudy{text.name, scene.shows});
    one.left_out = why_not_run(scene, exercises);
    if (!one.left_out.empty()) continue;
    for (const StudiedPart& part : parts_of(text))
      one.parts.push_back(study_part(part, true_motion(part, kept), theirs, ours, settings));
  }
  student.finish();
  reference.finish();
  study.student_seconds = student.cpu_seconds();
  study.reference_seconds = reference.cpu_seconds();
  return study;
}

}  // namespace grader::judge
