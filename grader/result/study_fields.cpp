// STAFF ONLY. Declares the fields of studies.
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"

namespace grader::inline result {

const Rows<StudyPoint>& Fields<StudyPoint>::rows() {
  using T = StudyPoint;
  const auto ended = [](const T& point) { return point.end != StudyEnd::broke; };
  static const Rows<T> all = {
      field("steps", &T::steps),
      field("end", &T::end),
      field<T>("note", &T::note, [](const T& point) { return !point.note.empty(); }),
      field<T>("error", &T::error, [](const T& point) { return point.end == StudyEnd::finished; }),
      field<T>("solver_steps", &T::solver_steps, ended),
      field<T>("correction_steps", &T::correction_steps, ended),
      field("first_seconds", &T::first_seconds),
      field("seconds", &T::seconds)};
  return all;
}

const Rows<StudyCurve>& Fields<StudyCurve>::rows() {
  using T = StudyCurve;
  static const Rows<T> all = {field("stable_steps", &T::stable_steps),
                              field("stable_everywhere", &T::stable_everywhere), field("points", &T::points)};
  return all;
}

const Rows<TimeRatio>& Fields<TimeRatio>::rows() {
  using T = TimeRatio;
  static const Rows<T> all = {field("median", &T::median), field("least", &T::least),
                              field("most", &T::most)};
  return all;
}

const Rows<PartStudy>& Fields<PartStudy>::rows() {
  using T = PartStudy;
  static const Rows<T> all = {
      field("name", &T::name),
      field("duration", &T::duration),
      field("own_steps", &T::own_steps),
      field("order", &T::order),
      field("truth", &T::truth),
      field("least_error", &T::least_error),
      field("rounds", &T::rounds),
      field("time_ratio", &T::ratio),
      field("note", &T::note),
      field<T>("noise", &T::noise, [](const T& part) { return part.noise.has_value(); }),
      field("student", &T::student),
      field("reference", &T::reference)};
  return all;
}

const Rows<SceneStudy>& Fields<SceneStudy>::rows() {
  using T = SceneStudy;
  static const Rows<T> all = {
      field("name", &T::name), field("shows", &T::shows), field("left_out", &T::left_out),
      field("parts", &T::parts),
      field<T>("exercises", &T::exercises, [](const T& scene) { return !scene.exercises.empty(); })};
  return all;
}

const Rows<SubmissionStudy>& Fields<SubmissionStudy>::rows() {
  using T = SubmissionStudy;
  static const Rows<T> all = {field("student_seconds", &T::student_seconds),
                              field("reference_seconds", &T::reference_seconds), field("scenes", &T::scenes)};
  return all;
}

}  // namespace grader::result
