// STAFF ONLY. The fields of costs.
#include "grader/result/costs.h"

#include <string_view>

#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"

namespace grader::inline result {
namespace {

// Is a measured quantity: its field in timing.json, and its column on the page.
struct Measured {
  Field<ExerciseTiming> field;
  CostColumn column;
};

std::vector<Measured> with_budget(std::vector<Measured> all) {
  for (const BudgetField& spent : budget_fields()) {
    const bool seconds = std::string_view(spent.key).ends_with("seconds");
    all.push_back({field(std::string("spent_") + spent.key, &ExerciseTiming::spent, spent.value),
                   {spent.heading, std::string("of the submission's budget: ") + spent.name,
                    seconds ? CostKind::cpu_seconds : CostKind::count}});
  }
  return all;
}

const std::vector<Measured>& all_measured() {
  using enum CostKind;
  using T = ExerciseTiming;
  static const std::vector<Measured> all = with_budget({
      {field("compile_seconds", &T::compile_seconds),
       {"Compiler", "seconds by the wall clock, linker included; 0 if it was cached", wall_seconds}},
      {field("suite_seconds", &T::suite_seconds),
       {"Suite", "seconds by the wall clock, with all that is to its right", wall_seconds}},
      {field("worker_cpu_seconds", &T::worker_cpu_seconds), {"Worker", "CPU seconds", cpu_seconds}},
      {field("worker_starts", &T::worker_starts), {"Starts", "of the worker", count}},
      {field("sanitised_cpu_seconds", &T::sanitised_cpu_seconds),
       {"Sanitised", "CPU seconds of the worker with sanitizers", cpu_seconds}},
      {field("run_cpu_seconds", &T::run_cpu_seconds),
       {"Whole run", "CPU seconds of its worker", cpu_seconds}},
      {field("picture_cpu_seconds", &T::picture_cpu_seconds),
       {"Pictures", "CPU seconds to draw and to compare", cpu_seconds}},
  });
  return all;
}

CostsByPart costs_of(const TimingByExercise& timing) {
  CostsByPart costs;
  for (const auto& [part, one] : timing)
    for (const Measured& measured : all_measured())
      costs[part].push_back(measured.field.write(one, {}).get<double>());
  return costs;
}

}  // namespace

const Rows<Budget>& Fields<Budget>::rows() {
  static const Rows<Budget> all = [] {
    Rows<Budget> rows;
    for (const BudgetField& one : budget_fields()) rows.push_back(field(one.key, one.value));
    return rows;
  }();
  return all;
}

const Rows<ExerciseTiming>& Fields<ExerciseTiming>::rows() {
  static const Rows<ExerciseTiming> all = [] {
    Rows<ExerciseTiming> rows;
    for (const Measured& measured : all_measured()) rows.push_back(measured.field);
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
  // Keys are sorted by their alphabet, so that columns on the page may have another order.
  const nlohmann::json sorted = to_json_value(costs, {});
  return sorted.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Costs costs_table(const ClassCosts& costs) {
  Costs table;
  for (const Measured& measured : all_measured()) table.columns.push_back(measured.column);
  table.reference = costs_of(costs.reference);
  for (const auto& [name, timing] : costs.submissions) table.submissions[name] = costs_of(timing);
  return table;
}

}  // namespace grader::result
