// STAFF ONLY.
#include "grader/tool/suite_run.h"

#include <signal.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "grader/result/base64.h"
#include "grader/result/study_json.h"
#include "grader/sandbox/descriptor.h"
#include "hair/io/files/start_program.h"

namespace grader {
namespace {

using nlohmann::json;

constexpr std::size_t kMostOutput = std::size_t{16} << 20;
// The suite's watchdog ends a student's worker long before; this is for the suite itself.
constexpr double kMostSeconds = 1200;

json texts(const std::vector<std::filesystem::path>& paths) {
  json all = json::array();
  for (const auto& path : paths) all.push_back(path.string());
  return all;
}

json to_json(const SuiteJob& job) {
  json all = {
      {"exercise", job.exercise},       {"seed", job.seed},
      {"kit", job.kit.string()},        {"provided", job.provided},
      {"objects", texts(job.objects)},  {"log", job.log.string()},
      {"isolated", job.isolated},       {"cpu_seconds", job.cpu_seconds},
      {"count_cases", job.count_cases}, {"pictures", job.pictures ? json(job.pictures->string()) : json()}};
  for (const BudgetField& field : budget_fields()) all["allowance"][field.key] = job.allowance.*field.value;
  if (job.sanitised) all["sanitised"] = job.sanitised->string();
  if (job.whole_run)
    all["whole_run"] = {{"scene", job.whole_run->scene.string()},
                        {"seed", job.whole_run->seed},
                        {"player", job.whole_run->player.string()},
                        {"cpu_seconds", job.whole_run->cpu_seconds}};
  if (job.exercise == "study") {
    all["reference_objects"] = texts(job.reference_objects);
    all["motions"] = job.motions.string();
  }
  if (job.exercise == "runs" || job.exercise == "study") {
    all["left_out"] = job.left_out;
    all["unavailable"] = job.unavailable;
  }
  return all;
}

// Runs a program that we trust, with `input` on its standard input, and returns its standard output.
std::string run_trusted(const std::filesystem::path& program, const std::string& input) {
  Pipe in = make_pipe(), out = make_pipe();
  const std::string name = program.string();
  const pid_t process =
      hair::start_program({.words = {name}, .input = in.read_end.get(), .output = out.write_end.get()});
  in.read_end.close();
  out.write_end.close();
  if (write(in.write_end.get(), input.data(), input.size()) != static_cast<ssize_t>(input.size()))
    throw std::runtime_error(name + " does not read its job");
  in.write_end.close();
  const std::string output = read_all(out.read_end, kMostOutput, kMostSeconds);
  out.read_end.close();
  if (output.empty() || output.back() != '\n')
    kill(process, SIGKILL);  // it has not ended, and is not waited for
  const std::optional<int> code = hair::exit_code_of(process);
  if (code != 0)
    throw std::runtime_error(name + " failed " +
                             (code ? "with exit code " + std::to_string(*code) : "by a signal"));
  return output;
}

std::vector<PictureResult> pictures_from(const json& found) {
  std::vector<PictureResult> pictures;
  const auto bytes = [](const json& text) { return from_base64(text.get_ref<const std::string&>()); };
  for (const json& one : found) {
    PictureResult picture{one.at("name"),           one.at("blurred_rmse"),     one.at("flip"),
                          bytes(one.at("student")), bytes(one.at("reference")), bytes(one.at("heat"))};
    picture.far_off = one.at("far_off");
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace

SuiteResult run_suite(const std::filesystem::path& suite, const SuiteJob& job) {
  const json found = json::parse(run_trusted(suite, to_json(job).dump()));
  SuiteResult result;
  result.cpu_seconds = found.at("cpu_seconds");
  result.starts = found.at("starts");
  result.allocations = found.value("allocations", 0);
  for (const BudgetField& field : budget_fields())
    result.spent.*field.value = found.at("spent").at(field.key);
  result.run_cpu_seconds = found.value("run_cpu_seconds", 0.0);
  result.picture_cpu_seconds = found.value("picture_cpu_seconds", 0.0);
  if (found.contains("memory")) {
    const json& memory = found.at("memory");
    result.memory_error = {memory.at("told"), memory.at("offsets")};
    result.sanitised_cpu_seconds = memory.at("cpu_seconds");
  }
  result.pictures = pictures_from(found.value("pictures", json::array()));
  for (const json& one : found.value("cases", json::array()))
    result.cases.push_back({one.at("name"), status_from_string(one.at("status")), one.at("points"),
                            one.at("weight"), one.at("feedback"), one.at("detail"), "", one.at("cases"),
                            one.at("held")});
  for (const json& one : found.value("runs", json::array()))
    result.runs.push_back({one.at("name"), one.at("shows"), run_outcome_from_string(one.at("outcome")),
                           one.at("feedback"), one.at("detail"), pictures_from(one.at("pictures"))});
  if (found.contains("study")) result.study = study_from_json(found.at("study").dump());
  return result;
}

}  // namespace grader
