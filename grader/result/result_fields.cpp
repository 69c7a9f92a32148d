// STAFF ONLY. Declares the fields of results, studies and costs.
#include "grader/result/result_fields.h"

#include <sodium.h>

#include "grader/result/json_fields.h"
#include "hair/io/files/base64.h"

namespace grader::inline result {

namespace {

// Throws std::invalid_argument for text that base64() can't produce.
std::string from_base64(const std::string& text) {
  std::string bytes(text.size() / 4 * 3, '\0');
  std::size_t size = 0;
  // Without an end pointer it fails if anything follows; nothing is ignored.
  if (sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(),
                        text.size(), nullptr, &size, nullptr, sodium_base64_VARIANT_ORIGINAL) != 0)
    throw std::invalid_argument("not base64");
  bytes.resize(size);
  return bytes;
}

}  // namespace

PictureText pictures_in_base64() {
  return {hair::base64, from_base64};
}

const Rows<CaseResult>& rows_of(As<CaseResult>) {
  using T = CaseResult;
  static const Rows<T> all = {field("name", &T::name),
                              field("status", &T::status),
                              field("points", &T::points),
                              field("max_points", &T::max_points),
                              field("feedback", &T::feedback),
                              field("detail", &T::detail),
                              field_if_set("hint", &T::hint),
                              field("cases", &T::cases),
                              field("held", &T::held),
                              field_if_set("error_in_limits", &T::error_in_limits),
                              of_earlier_versions<T>("memory_error"),
                              of_earlier_versions<T>("memory_error_in")};
  return all;
}

const Rows<PictureResult>& rows_of(As<PictureResult>) {
  using T = PictureResult;
  static const Rows<T> all = {field("name", &T::name),
                              field("blurred_rmse", &T::blurred_rmse),
                              field("flip", &T::flip),
                              field_if_set("apart", &T::apart),
                              picture("student", &T::student),
                              picture("reference", &T::reference),
                              picture("heat", &T::heat),
                              field("far_off", &T::far_off),
                              field_if_set("breaks_off", &T::breaks_off),
                              of_earlier_versions<T>("blurred_rmse_limit"),
                              of_earlier_versions<T>("flip_limit")};
  return all;
}

const Rows<RunMotions>& rows_of(As<RunMotions>) {
  using T = RunMotions;
  static const Rows<T> all = {picture("student", &T::student), picture("reference", &T::reference),
                              picture("film", &T::film)};
  return all;
}

const Rows<Said>& rows_of(As<Said>) {
  using T = Said;
  static const Rows<T> all = {field("place", &T::place), field("code", &T::code), field("text", &T::text)};
  return all;
}

const Rows<ExerciseResult>& rows_of(As<ExerciseResult>) {
  using T = ExerciseResult;
  static const Rows<T> all = {field("id", &T::id),
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
                              field_if_set("motions", &T::motions),
                              field("staff_log", &T::staff_log),
                              field_if_set("source", &T::source),
                              field_if_set("said", &T::said),
                              of_earlier_versions<T>("allocations")};
  return all;
}

const Rows<Adjustment>& rows_of(As<Adjustment>) {
  using T = Adjustment;
  static const Rows<T> all = {field("reason", &T::reason), field("points", &T::points)};
  return all;
}

const Rows<SubmissionResult>& rows_of(As<SubmissionResult>) {
  using T = SubmissionResult;
  static const Rows<T> all = {field("name", &T::name),
                              field("origin", &T::origin),
                              field("fingerprint", &T::fingerprint),
                              field("isolation", &T::isolation),
                              field("images", &T::images),
                              field("note", &T::note),
                              field("exercises", &T::exercises),
                              of_earlier_versions<T>("runs"),
                              field_if_set("ended_by_the_clock", &T::ended_by_the_clock),
                              field_if_set("studied", &T::studied),
                              field_if_set("extra_credit_counted", &T::extra_credit_counted),
                              field_if_set("adjustments", &T::adjustments),
                              field_if_set("remarks", &T::remarks),
                              field_if_set("about", &T::about)};
  return all;
}

const Rows<SuiteResult>& rows_of(As<SuiteResult>) {
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

const Rows<StudyPoint>& rows_of(As<StudyPoint>) {
  using T = StudyPoint;
  const auto ended = [](const T& point) { return point.end != StudyEnd::broke; };
  static const Rows<T> all = {
      field("steps", &T::steps),
      field("end", &T::end),
      field_if_set("note", &T::note),
      field<T>("error", &T::error, [](const T& point) { return point.end == StudyEnd::finished; }),
      field<T>("solver_steps", &T::solver_steps, ended),
      field<T>("correction_steps", &T::correction_steps, ended),
      field("first_seconds", &T::first_seconds),
      field("seconds", &T::seconds)};
  return all;
}

const Rows<StudyCurve>& rows_of(As<StudyCurve>) {
  using T = StudyCurve;
  static const Rows<T> all = {field("stable_steps", &T::stable_steps),
                              field("stable_everywhere", &T::stable_everywhere), field("points", &T::points)};
  return all;
}

const Rows<TimeRatio>& rows_of(As<TimeRatio>) {
  using T = TimeRatio;
  static const Rows<T> all = {field("median", &T::median), field("least", &T::least),
                              field("most", &T::most)};
  return all;
}

const Rows<PartStudy>& rows_of(As<PartStudy>) {
  using T = PartStudy;
  static const Rows<T> all = {field("name", &T::name),           field("duration", &T::duration),
                              field("own_steps", &T::own_steps), field("order", &T::order),
                              field("truth", &T::truth),         field("least_error", &T::least_error),
                              field("rounds", &T::rounds),       field("time_ratio", &T::ratio),
                              field("note", &T::note),           field_if_set("noise", &T::noise),
                              field("student", &T::student),     field("reference", &T::reference)};
  return all;
}

const Rows<SceneStudy>& rows_of(As<SceneStudy>) {
  using T = SceneStudy;
  static const Rows<T> all = {field("name", &T::name), field("shows", &T::shows),
                              field("left_out", &T::left_out), field("parts", &T::parts),
                              field_if_set("exercises", &T::exercises)};
  return all;
}

const Rows<SubmissionStudy>& rows_of(As<SubmissionStudy>) {
  using T = SubmissionStudy;
  static const Rows<T> all = {field("student_seconds", &T::student_seconds),
                              field("reference_seconds", &T::reference_seconds), field("scenes", &T::scenes)};
  return all;
}

const Rows<Budget>& rows_of(As<Budget>) {
  static const Rows<Budget> all = [] {
    Rows<Budget> rows;
    for (const BudgetField& one : budget_fields()) rows.push_back(field(one.key, one.value));
    return rows;
  }();
  return all;
}

const Rows<ExerciseTiming>& rows_of(As<ExerciseTiming>) {
  using T = ExerciseTiming;
  static const Rows<T> all = [] {
    Rows<T> rows = {field("compile_seconds", &T::compile_seconds),
                    field("suite_seconds", &T::suite_seconds),
                    field("worker_cpu_seconds", &T::worker_cpu_seconds),
                    field("worker_starts", &T::worker_starts),
                    field("run_cpu_seconds", &T::run_cpu_seconds),
                    field("picture_cpu_seconds", &T::picture_cpu_seconds),
                    of_earlier_versions<T>("sanitised_cpu_seconds")};
    for (const BudgetField& spent : budget_fields())
      rows.push_back(field(std::string("spent_") + spent.key, &T::spent, spent.value));
    return rows;
  }();
  return all;
}

const Rows<LastRun>& rows_of(As<LastRun>) {
  using T = LastRun;
  static const Rows<T> all = {
      field("wall_seconds", &T::wall_seconds),
      field("graded", &T::graded),
      field("jobs", &T::jobs),
      computed<T>("submissions_per_minute",
                  [](const T& run) { return run.wall_seconds > 0 ? 60 * run.graded / run.wall_seconds : 0; }),
      field_if_set("began", &T::began),
      field_if_set("ended", &T::ended),
      field_if_set("asked", &T::asked),
      field_if_set("done", &T::done)};
  return all;
}

const Rows<ClassCosts>& rows_of(As<ClassCosts>) {
  using T = ClassCosts;
  static const Rows<T> all = {field("reference", &T::reference), field("submissions", &T::submissions),
                              field_if_set("ended_by_the_clock", &T::ended_by_the_clock),
                              field_if_set("last_run", &T::last_run)};
  return all;
}

std::string to_json(const ClassCosts& costs) {
  // Keys are sorted by their alphabet.
  const nlohmann::json sorted = to_json_value(costs, {});
  return sorted.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace grader::result
