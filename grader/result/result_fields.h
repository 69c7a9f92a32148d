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

const Rows<CaseResult>& rows_of(As<CaseResult>);
const Rows<PictureResult>& rows_of(As<PictureResult>);
const Rows<RunMotions>& rows_of(As<RunMotions>);
const Rows<Said>& rows_of(As<Said>);
const Rows<ExerciseResult>& rows_of(As<ExerciseResult>);
const Rows<Adjustment>& rows_of(As<Adjustment>);
const Rows<SubmissionResult>& rows_of(As<SubmissionResult>);

const Rows<StudyPoint>& rows_of(As<StudyPoint>);
const Rows<StudyCurve>& rows_of(As<StudyCurve>);
const Rows<TimeRatio>& rows_of(As<TimeRatio>);
const Rows<PartStudy>& rows_of(As<PartStudy>);
const Rows<SceneStudy>& rows_of(As<SceneStudy>);
const Rows<SubmissionStudy>& rows_of(As<SubmissionStudy>);

const Rows<Budget>& rows_of(As<Budget>);
const Rows<ExerciseTiming>& rows_of(As<ExerciseTiming>);
const Rows<LastRun>& rows_of(As<LastRun>);
const Rows<ClassCosts>& rows_of(As<ClassCosts>);

const Rows<SuiteResult>& rows_of(As<SuiteResult>);

}  // namespace grader::result
