// STAFF ONLY. The fields of costs.
#include "grader/result/costs.h"

#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"

namespace grader::inline result {

const Rows<Budget>& Fields<Budget>::rows() {
  static const Rows<Budget> all = [] {
    Rows<Budget> rows;
    for (const BudgetField& one : budget_fields()) rows.push_back(field(one.key, one.value));
    return rows;
  }();
  return all;
}

const Rows<ExerciseTiming>& Fields<ExerciseTiming>::rows() {
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

const Rows<LastRun>& Fields<LastRun>::rows() {
  using T = LastRun;
  static const Rows<T> all = {
      field("wall_seconds", &T::wall_seconds),
      field("graded", &T::graded),
      field("jobs", &T::jobs),
      computed<T>("submissions_per_minute",
                  [](const T& run) { return run.wall_seconds > 0 ? 60 * run.graded / run.wall_seconds : 0; }),
      field<T>("began", &T::began, [](const T& run) { return !run.began.empty(); }),
      field<T>("ended", &T::ended, [](const T& run) { return !run.ended.empty(); }),
      field<T>("asked", &T::asked, [](const T& run) { return run.asked > 0; }),
      field<T>("done", &T::done, [](const T& run) { return run.done > 0; })};
  return all;
}

const Rows<ClassCosts>& Fields<ClassCosts>::rows() {
  using T = ClassCosts;
  static const Rows<T> all = {
      field("reference", &T::reference), field("submissions", &T::submissions),
      field<T>("ended_by_the_clock", &T::ended_by_the_clock,
               [](const T& costs) { return !costs.ended_by_the_clock.empty(); }),
      field<T>("last_run", &T::last_run, [](const T& costs) { return costs.last_run.has_value(); })};
  return all;
}

std::string to_json(const ClassCosts& costs) {
  // Keys are sorted by their alphabet.
  const nlohmann::json sorted = to_json_value(costs, {});
  return sorted.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace grader::result
