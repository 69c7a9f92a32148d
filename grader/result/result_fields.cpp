// STAFF ONLY. Declares the fields of results.
#include "grader/result/result_fields.h"

#include "grader/result/base64.h"
#include "grader/result/json_fields.h"

namespace grader::inline result {

PictureText pictures_in_base64() {
  return {[](const std::string& png) { return base64(png); },
          [](const std::string& text) { return from_base64(text); }};
}

const Rows<CaseResult>& Fields<CaseResult>::rows() {
  using T = CaseResult;
  static const Rows<T> all = {
      field("name", &T::name),
      field("status", &T::status),
      field("points", &T::points),
      field("max_points", &T::max_points),
      field("feedback", &T::feedback),
      field("detail", &T::detail),
      field<T>("hint", &T::hint, [](const T& one) { return !one.hint.empty(); }),
      field("cases", &T::cases),
      field("held", &T::held),
      field<T>("error_in_limits", &T::error_in_limits, [](const T& one) { return one.error_in_limits != 0; }),
      of_earlier_versions<T>("memory_error"),
      of_earlier_versions<T>("memory_error_in")};
  return all;
}

const Rows<PictureResult>& Fields<PictureResult>::rows() {
  using T = PictureResult;
  static const Rows<T> all = {
      field("name", &T::name),
      field("blurred_rmse", &T::blurred_rmse),
      field("flip", &T::flip),
      field<T>("apart", &T::apart, [](const T& one) { return one.apart != 0; }),
      picture("student", &T::student),
      picture("reference", &T::reference),
      picture("heat", &T::heat),
      field("far_off", &T::far_off),
      field<T>("breaks_off", &T::breaks_off, [](const T& one) { return one.breaks_off; }),
      of_earlier_versions<T>("blurred_rmse_limit"),
      of_earlier_versions<T>("flip_limit")};
  return all;
}

const Rows<RunMotions>& Fields<RunMotions>::rows() {
  using T = RunMotions;
  static const Rows<T> all = {picture("student", &T::student), picture("reference", &T::reference),
                              picture("film", &T::film)};
  return all;
}

const Rows<Said>& Fields<Said>::rows() {
  using T = Said;
  static const Rows<T> all = {field("place", &T::place), field("code", &T::code), field("text", &T::text)};
  return all;
}

const Rows<ExerciseResult>& Fields<ExerciseResult>::rows() {
  using T = ExerciseResult;
  static const Rows<T> all = {
      field("id", &T::id),
      field("title", &T::title),
      field("file", &T::file),
      field("extra_credit", &T::extra_credit),
      field("status", &T::status),
      field("points", &T::points),
      field("max_points", &T::max_points),
      field("feedback", &T::feedback),
      field("compiler_messages", &T::compiler_messages),
      field("cases", &T::cases),
      field("pictures", &T::pictures),
      field<T>("motions", &T::motions, [](const T& one) { return one.motions != RunMotions{}; }),
      field("staff_log", &T::staff_log),
      field<T>("source", &T::source, [](const T& one) { return !one.source.empty(); }),
      field<T>("said", &T::said, [](const T& one) { return !one.said.empty(); }),
      of_earlier_versions<T>("allocations")};
  return all;
}

const Rows<Adjustment>& Fields<Adjustment>::rows() {
  using T = Adjustment;
  static const Rows<T> all = {field("reason", &T::reason), field("points", &T::points)};
  return all;
}

const Rows<SubmissionResult>& Fields<SubmissionResult>::rows() {
  using T = SubmissionResult;
  static const Rows<T> all = {
      field("name", &T::name),
      field("origin", &T::origin),
      field("fingerprint", &T::fingerprint),
      field("isolation", &T::isolation),
      field("images", &T::images),
      field("note", &T::note),
      field("exercises", &T::exercises),
      of_earlier_versions<T>("runs"),
      field<T>("ended_by_the_clock", &T::ended_by_the_clock,
               [](const T& result) { return !result.ended_by_the_clock.empty(); }),
      field<T>("studied", &T::studied, [](const T& result) { return result.studied; }),
      field<T>("extra_credit_counted", &T::extra_credit_counted,
               [](const T& result) { return result.extra_credit_counted.has_value(); }),
      field<T>("adjustments", &T::adjustments, [](const T& result) { return !result.adjustments.empty(); }),
      field<T>("remarks", &T::remarks, [](const T& result) { return !result.remarks.empty(); }),
      field<T>("about", &T::about, [](const T& result) { return !result.about.empty(); })};
  return all;
}

const Rows<SuiteResult>& Fields<SuiteResult>::rows() {
  using T = SuiteResult;
  static const Rows<T> all = {field("cases", &T::cases),
                              field("pictures", &T::pictures),
                              field("motions", &T::motions),
                              field("study", &T::study),
                              field("cpu_seconds", &T::cpu_seconds),
                              field("run_cpu_seconds", &T::run_cpu_seconds),
                              field("picture_cpu_seconds", &T::picture_cpu_seconds),
                              field("starts", &T::starts),
                              field("spent", &T::spent),
                              field("reproduced", &T::reproduced)};
  return all;
}

}  // namespace grader::result
