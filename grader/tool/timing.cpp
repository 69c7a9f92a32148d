// STAFF ONLY.
#include "grader/tool/timing.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"

namespace grader {
namespace {

using nlohmann::json;

json to_json(const TimingByExercise& timing) {
  json result = json::object();
  for (const auto& [exercise, one] : timing) {
    result[exercise] = {
        {"compile_seconds", one.compile_seconds},       {"suite_seconds", one.suite_seconds},
        {"worker_cpu_seconds", one.worker_cpu_seconds}, {"worker_starts", one.worker_starts},
        {"run_cpu_seconds", one.run_cpu_seconds},       {"picture_cpu_seconds", one.picture_cpu_seconds}};
    for (const BudgetField& field : budget_fields())
      result[exercise]["spent"][field.key] = one.spent.*field.value;
  }
  return result;
}

}  // namespace

void write_timing(const std::filesystem::path& out, const TimingByExercise& reference,
                  const std::map<std::string, TimingByExercise>& submissions, double wall_seconds, int graded,
                  int jobs) {
  const std::filesystem::path file = out / "timing.json";
  json all = json::object();
  std::ifstream before(file);
  if (before) {
    const json parsed = json::parse(before, nullptr, false);
    if (parsed.is_object()) all = parsed;
  }
  all["reference"] = to_json(reference);
  for (const auto& [name, timing] : submissions) all["submissions"][name] = to_json(timing);
  all["last_run"] = {{"wall_seconds", wall_seconds},
                     {"graded", graded},
                     {"jobs", jobs},
                     {"submissions_per_minute", wall_seconds > 0 ? 60 * graded / wall_seconds : 0}};
  write_file(file, all.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace grader
