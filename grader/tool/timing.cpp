// STAFF ONLY.
#include "grader/tool/timing.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "grader/course/input.h"
#include "grader/report/costs_page.h"

namespace grader {
namespace {

using nlohmann::json;

// What is measured. A row here is all that timing.json and the page need for a new member of ExerciseTiming.
struct Measured {
  std::string key;
  std::variant<double ExerciseTiming::*, int ExerciseTiming::*, double Budget::*> member;
  CostColumn column;
};

// A member of a timing, or of what it says was spent.
template <class Timing, class Type>
auto& value_of(Timing& one, Type ExerciseTiming::*member) {
  return one.*member;
}
template <class Timing>
auto& value_of(Timing& one, double Budget::*member) {
  return one.spent.*member;
}

CostKind kind_of(std::string_view key) {
  return key.ends_with("seconds") ? CostKind::cpu_seconds : CostKind::count;
}

std::vector<Measured> with_budget(std::vector<Measured> all) {
  for (const BudgetField& field : budget_fields())
    all.push_back(
        {std::string("spent_") + field.key,
         field.value,
         {field.heading, std::string("of the submission's budget: ") + field.name, kind_of(field.key)}});
  return all;
}

const std::vector<Measured>& all_measured() {
  using enum CostKind;
  static const std::vector<Measured> all = with_budget({
      {"compile_seconds",
       &ExerciseTiming::compile_seconds,
       {"Compiler", "seconds by the wall clock, linker included; 0 if it was cached", wall_seconds}},
      {"suite_seconds",
       &ExerciseTiming::suite_seconds,
       {"Suite", "seconds by the wall clock, with all that is to its right", wall_seconds}},
      {"worker_cpu_seconds", &ExerciseTiming::worker_cpu_seconds, {"Worker", "CPU seconds", cpu_seconds}},
      {"worker_starts", &ExerciseTiming::worker_starts, {"Starts", "of the worker", count}},
      {"sanitised_cpu_seconds",
       &ExerciseTiming::sanitised_cpu_seconds,
       {"Sanitised", "CPU seconds of the worker with sanitizers", cpu_seconds}},
      {"run_cpu_seconds",
       &ExerciseTiming::run_cpu_seconds,
       {"Whole run", "CPU seconds of its worker", cpu_seconds}},
      {"picture_cpu_seconds",
       &ExerciseTiming::picture_cpu_seconds,
       {"Pictures", "CPU seconds to draw and to compare", cpu_seconds}},
  });
  return all;
}

json to_json(const TimingByExercise& timing) {
  json result = json::object();
  for (const auto& [exercise, one] : timing)
    for (const Measured& measured : all_measured())
      std::visit([&, &exercise = exercise,
                  &one = one](auto member) { result[exercise][measured.key] = value_of(one, member); },
                 measured.member);
  return result;
}

// What an older file does not have is 0.
TimingByExercise timing_from(const json& parts) {
  TimingByExercise timing;
  for (const auto& [part, values] : parts.items())
    for (const Measured& measured : all_measured())
      if (const auto found = values.find(measured.key); found != values.end() && found->is_number())
        std::visit([&, &part = part](auto member) { found->get_to(value_of(timing[part], member)); },
                   measured.member);
  return timing;
}

CostsByPart costs_of(const TimingByExercise& timing) {
  CostsByPart costs;
  for (const auto& [part, one] : timing)
    for (const Measured& measured : all_measured())
      std::visit([&, &part = part, &one = one](
                     auto member) { costs[part].push_back(static_cast<double>(value_of(one, member))); },
                 measured.member);
  return costs;
}

}  // namespace

Timing::Timing(std::filesystem::path folder, const TimingByExercise& reference, bool merge)
    : folder_(std::move(folder)), merge_(merge) {
  std::ifstream before(folder_ / "timing.json");
  const json all = before ? json::parse(before, nullptr, false) : json();
  if (all.is_object() && all.contains("reference")) reference_ = timing_from(all["reference"]);
  if (all.is_object() && all.contains("submissions"))
    for (const auto& [name, parts] : all["submissions"].items()) submissions_[name] = timing_from(parts);
  put(reference_, reference);
}

void Timing::put(TimingByExercise& place, const TimingByExercise& timing) const {
  if (!merge_) place.clear();
  for (const auto& [part, one] : timing) place.insert_or_assign(part, one);
}

void Timing::write(const LastRun* run) const {
  json all = {{"reference", to_json(reference_)}, {"submissions", json::object()}};
  for (const auto& [name, timing] : submissions_) all["submissions"][name] = to_json(timing);
  if (run != nullptr)
    all["last_run"] = {
        {"wall_seconds", run->wall_seconds},
        {"graded", run->graded},
        {"jobs", run->jobs},
        {"submissions_per_minute", run->wall_seconds > 0 ? 60 * run->graded / run->wall_seconds : 0}};
  write_file(folder_ / "timing.json", all.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

void Timing::add(const std::string& submission, const TimingByExercise& timing) {
  put(submissions_[submission], timing);
  write(nullptr);
}

void Timing::finish(const std::vector<SubmissionResult>& results, const LastRun& run) {
  std::erase_if(submissions_, [&](const auto& one) {
    return std::none_of(results.begin(), results.end(),
                        [&](const SubmissionResult& result) { return result.name == one.first; });
  });
  write(&run);
  Costs costs;
  for (const Measured& measured : all_measured()) costs.columns.push_back(measured.column);
  costs.reference = costs_of(reference_);
  for (const auto& [name, timing] : submissions_) costs.submissions[name] = costs_of(timing);
  write_file(folder_ / "costs.html", costs_page(costs));
}

}  // namespace grader
