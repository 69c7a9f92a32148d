// STAFF ONLY. The structs of results, studies and costs that have declared fields (fields.h).
//
//   staff/NAME.json     json_text(SubmissionResult, 1); pictures are names of files (facts/picture_files.h)
//   NAME/study.json     json_text(SubmissionStudy, 1); grader/result/study.h describes it
//   timing.json         to_json(ClassCosts)
//   hairsuite's output  json_text(SuiteResult, -1)
#pragma once

#include "grader/result/costs.h"
#include "grader/result/fields.h"
#include "grader/result/result.h"
#include "grader/result/study.h"
#include "grader/result/suite_result.h"

namespace grader::inline result {

template <>
inline constexpr Status kLast<Status> = Status::excused;
template <>
inline constexpr Isolation kLast<Isolation> = Isolation::container;
template <>
inline constexpr StudyEnd kLast<StudyEnd> = StudyEnd::broke;

template <>
struct Fields<CaseResult> {
  static const Rows<CaseResult>& rows();
};
template <>
struct Fields<PictureResult> {
  static const Rows<PictureResult>& rows();
};
template <>
struct Fields<RunMotions> {
  static const Rows<RunMotions>& rows();
};
template <>
struct Fields<Said> {
  static const Rows<Said>& rows();
};
template <>
struct Fields<ExerciseResult> {
  static const Rows<ExerciseResult>& rows();
};
template <>
struct Fields<Adjustment> {
  static const Rows<Adjustment>& rows();
};
template <>
struct Fields<SubmissionResult> {
  static const Rows<SubmissionResult>& rows();
};

template <>
struct Fields<StudyPoint> {
  static const Rows<StudyPoint>& rows();
};
template <>
struct Fields<StudyCurve> {
  static const Rows<StudyCurve>& rows();
};
template <>
struct Fields<TimeRatio> {
  static const Rows<TimeRatio>& rows();
};
template <>
struct Fields<PartStudy> {
  static const Rows<PartStudy>& rows();
};
template <>
struct Fields<SceneStudy> {
  static const Rows<SceneStudy>& rows();
};
template <>
struct Fields<SubmissionStudy> {
  static const Rows<SubmissionStudy>& rows();
};

template <>
struct Fields<Budget> {
  static const Rows<Budget>& rows();
};
template <>
struct Fields<ExerciseTiming> {
  static const Rows<ExerciseTiming>& rows();
};
template <>
struct Fields<LastRun> {
  static const Rows<LastRun>& rows();
};
template <>
struct Fields<ClassCosts> {
  static const Rows<ClassCosts>& rows();
};

template <>
struct Fields<SuiteResult> {
  static const Rows<SuiteResult>& rows();
};

}  // namespace grader::result
