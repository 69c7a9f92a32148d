// STAFF ONLY.
#include "grader/study/submission_study.h"

namespace grader {
namespace {

// Code that never answered, or did what it must not, is not asked again.
class UntilItGivesUp : public Player {
 public:
  explicit UntilItGivesUp(Student& student) : player_(student) {}

  Play play(const SceneText& text, const hair::Scene& scene, int times) override {
    if (end_) throw CaseFailed(*end_);
    try {
      return player_.play(text, scene, times);
    } catch (const CaseFailed& failure) {
      if (failure.status == Status::timed_out || failure.status == Status::broke_rules) end_ = failure;
      throw;
    }
  }

 private:
  WorkerPlayer player_;
  std::optional<CaseFailed> end_;
};

}  // namespace

SubmissionStudy study_submission(Student& student, Student& reference, const AvailableExercises& exercises,
                                 const std::optional<std::filesystem::path>& kept,
                                 const StudySettings& settings) {
  UntilItGivesUp theirs(student);
  WorkerPlayer ours(reference);
  SubmissionStudy study;
  for (const SceneText& text : end_to_end_scenes()) {
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

}  // namespace grader
