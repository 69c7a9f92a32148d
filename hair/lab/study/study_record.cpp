#include "hair/lab/study/study_record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/strict_json.h"

namespace hair {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMost = 1e300;
constexpr long kMostCount = 1L << 52;

constexpr std::array<const char*, 3> kEndings = {"finished", "broke", "useless"};
constexpr std::array<const char*, 5> kSweepEnds = {"unfinished", "below the reference's floor",
                                                   "smaller steps make no difference",
                                                   "the next would take too long", "not written"};

// A norm that the problem has not is left out.
template <typename Value>
Json json_of(const Errors& errors, Value value) {
  Json json = Json::object();
  for (int k = 0; k < kNorms; ++k) {
    const Norm norm = static_cast<Norm>(k);
    if (!std::isnan(errors[norm])) json[name_of(norm).id] = value(norm);
  }
  return json;
}

Json json_of(const MethodRun& run, const Errors& floors) {
  const Counts& counts = run.counts;
  Json json = {{"steps_per_moment", run.steps_per_moment},
               {"step", run.step},
               {"ending", name_of(run.ending)},
               {"trouble", run.trouble},
               {"steps", counts.steps},
               {"evaluations", counts.evaluations},
               {"iterations", counts.iterations},
               {"corrections", counts.corrections},
               {"unconverged", counts.unconverged}};
  if (run.ending == RunEnding::finished)
    json["errors"] = json_of(run.errors, [&](Norm norm) {
      return run.errors[norm] < floors[norm] ? Json(nullptr) : Json(run.errors[norm]);
    });
  json["time"] = run.time();
  json["seconds"] = run.seconds;
  return json;
}

Json json_of(const Machine& machine) {
  return {{"processor", machine.processor},
          {"cores", machine.cores},
          {"compiler", machine.compiler},
          {"build", machine.build},
          {"eigen", machine.eigen}};
}

Json json_of(const std::optional<SpaceError>& space) {
  if (!space) return nullptr;
  if (!space->left_out.empty()) return {{"left_out", space->left_out}};
  Json levels = Json::array();
  for (const SpaceLevel& level : space->levels)
    levels.push_back({{"segments", level.segments}, {"error", level.error}});
  return {{"levels", levels},
          {"order", space->order},
          {"time_error", space->time_error},
          {"stretch", space->stretch},
          {"seconds", space->cpu_seconds}};
}

Errors read_errors(const JsonValue& json) {
  Errors errors;
  for (int k = 0; k < kNorms; ++k) {
    const Norm norm = static_cast<Norm>(k);
    errors[norm] = std::nan("");
    if (!json.has(name_of(norm).id)) continue;
    const JsonValue error = json[name_of(norm).id];
    errors[norm] = error.is_null() ? 0 : error.number(0, kMost);
  }
  return errors;
}

MethodRun read_run(const JsonValue& json) {
  json.check_keys({"steps_per_moment", "step", "ending", "trouble", "steps", "evaluations", "iterations",
                   "corrections", "unconverged", "time", "seconds"},
                  {"errors"});
  MethodRun run;
  run.steps_per_moment = static_cast<int>(json["steps_per_moment"].whole_number(1, 1 << 30));
  run.step = json["step"].number(0, kMost);
  run.ending = static_cast<RunEnding>(json["ending"].word({kEndings[0], kEndings[1], kEndings[2]}));
  if (run.ending != RunEnding::finished) run.trouble = json["trouble"].text();
  run.counts = {json["steps"].whole_number(0, kMostCount), json["evaluations"].whole_number(0, kMostCount),
                json["iterations"].whole_number(0, kMostCount),
                json["corrections"].whole_number(0, kMostCount),
                json["unconverged"].whole_number(0, kMostCount)};
  if (run.ending == RunEnding::finished) {
    if (!json.has("errors")) json.fail("\"errors\" is missing; a run that finished has some");
    run.errors = read_errors(json["errors"]);
  }
  for (const JsonValue& seconds : json["seconds"].items()) run.seconds.push_back(seconds.number(0, kMost));
  if (run.seconds.empty()) json["seconds"].fail("is empty; a run has the time of each repeat");
  return run;
}

// Each of half the step before.
std::vector<MethodRun> read_sweep(const JsonValue& json) {
  std::vector<MethodRun> runs;
  for (const JsonValue& one : json.items()) {
    MethodRun run = read_run(one);
    if (!runs.empty() && run.steps_per_moment != 2L * runs.back().steps_per_moment)
      one["steps_per_moment"].fail(std::to_string(run.steps_per_moment) +
                                   " is not right; it is twice that of the run before, " +
                                   std::to_string(2L * runs.back().steps_per_moment));
    runs.push_back(std::move(run));
  }
  return runs;
}

// All but the runs, which are written a line each.
Json head_of(const Study& study) {
  bool finished = true;
  Json methods = Json::array();
  for (const Sweep& sweep : study.sweeps) {
    finished = finished && sweep.end != SweepEnd::unfinished;
    methods.push_back({{"id", sweep.method.id},
                       {"name", sweep.method.name},
                       {"order", sweep.method.order()},
                       {"explicit", sweep.method.is_explicit()},
                       {"end", name_of(sweep.end)},
                       {"left_out", sweep.left_out}});
  }
  return {{"program", "hairlab study"},
          {"format", kStudyFormat},
          {"finished", finished},
          {"scene", study.scene},
          {"shows", study.shows},
          {"content", study.content},
          {"quick", study.quick},
          {"duration", study.duration},
          {"strand", study.strand},
          {"particles", study.particles},
          {"size", study.size},
          {"tolerance", study.tolerance},
          {"most_work", study.most_work},
          {"machine", json_of(study.machine)},
          {"program_digest", study.program_digest},
          {"reference",
           {{"method", study.reference},
            {"agreement", study.agreement},
            {"least_error", study.least_error},
            {"inextensible", study.inextensible},
            {"from_cache", study.from_cache},
            {"seconds", study.reference_seconds}}},
          {"floors", json_of(study.floors, [&](Norm norm) { return Json(study.floors[norm]); })},
          {"space_error", json_of(study.space_error)},
          {"methods", methods}};
}

// What must be the same, for runs to go on from: everything that the record says but the runs themselves, how
// long the reference took, and whether it is finished; and what follows from the reference, if that is known.
nlohmann::json identity(nlohmann::json same, bool has_reference) {
  same.erase("finished");
  same.erase("space_error");
  same["reference"].erase("seconds");
  same["reference"].erase("from_cache");
  if (!has_reference)
    for (const char* key : {"reference", "floors", "particles"}) same.erase(key);
  for (nlohmann::json& method : same["methods"])
    if (method.is_object())
      for (const char* key : {"end", "left_out", "runs"}) method.erase(key);
  return same;
}

// The first key whose values differ.
std::string difference(const nlohmann::json& before, const nlohmann::json& now) {
  for (const auto& entry : now.items()) {
    const std::string& key = entry.key();
    if (before.contains(key) && before[key] == entry.value()) continue;
    const auto shown = [&](const nlohmann::json& json) {
      return json.contains(key) ? printable(json[key].dump(), 120) : std::string("nothing");
    };
    return "its \"" + key + "\" is " + shown(before) + ", not " + shown(now);
  }
  return "it is of another form";
}

}  // namespace

const char* name_of(RunEnding ending) {
  return kEndings[static_cast<int>(ending)];
}

const char* name_of(SweepEnd end) {
  return kSweepEnds[static_cast<int>(end)];
}

std::string study_json(const Study& study) {
  const Json head = head_of(study);
  std::string text = "{\n";
  for (const auto& [key, value] : head.items())
    if (key != "methods") text += "  " + Json(key).dump() + ": " + value.dump() + ",\n";
  text += "  \"methods\": [";
  for (std::size_t i = 0; i < study.sweeps.size(); ++i) {
    const std::string about = head["methods"][i].dump();
    text += (i == 0 ? "\n    " : ",\n    ") + about.substr(0, about.size() - 1) + ", \"runs\": [";
    const std::vector<MethodRun>& runs = study.sweeps[i].runs;
    for (std::size_t k = 0; k < runs.size(); ++k)
      text += (k == 0 ? "\n      " : ",\n      ") + json_of(runs[k], study.floors).dump();
    text += "]}";
  }
  return text + "\n  ]\n}\n";
}

void read_runs(const std::filesystem::path& file, Study& study) {
  const nlohmann::json record = read_json(file);
  const std::string name = printable(file.string(), 4096);
  if (!record.is_object() || !record.contains("program") || record["program"] != "hairlab study" ||
      !record.contains("methods") || !record["methods"].is_array() || !record.contains("reference") ||
      !record["reference"].is_object())
    throw BadInput(name + ": is not from hairlab study; give the --out of an earlier study");
  const bool has_reference = !study.reference.empty();
  const nlohmann::json now = identity(head_of(study), has_reference),
                       before = identity(record, has_reference);
  if (!before.contains("program_digest") || before["program_digest"] != now["program_digest"])
    throw BadInput(name +
                   ": can't be resumed: the program is another than the one that began this study; "
                   "build that one again, or leave out --resume to replace the study");
  if (before != now)
    throw BadInput(name + ": is another study, and can't be resumed: " + difference(before, now) +
                   "; give another --out, or leave out --resume to replace it");
  const std::vector<JsonValue> methods = JsonValue(record, file)["methods"].items();
  for (std::size_t i = 0; i < methods.size(); ++i) {
    methods[i].check_keys({"id", "name", "order", "explicit", "end", "left_out", "runs"});
    study.sweeps[i].runs = read_sweep(methods[i]["runs"]);
  }
}

Table table_of_runs(const Study& study) {
  Table table;
  table.caption = "All runs";
  table.header = {"method",      "steps_per_moment", "step_s",      "ending",      "trouble", "steps",
                  "evaluations", "iterations",       "corrections", "unconverged", "cpu_s",   "repeats"};
  for (int k = 0; k < kNorms; ++k) table.header.emplace_back(name_of(static_cast<Norm>(k)).id);
  table.header.emplace_back("space_error");
  std::optional<double> space;
  if (study.space_error) space = study.space_error->error_of(study.particles - 1);
  for (const Sweep& sweep : study.sweeps)
    for (const MethodRun& run : sweep.runs) {
      const Counts& counts = run.counts;
      std::vector<std::string> row = {sweep.method.id,
                                      std::to_string(run.steps_per_moment),
                                      to_exact_text(run.step),
                                      name_of(run.ending),
                                      run.trouble,
                                      std::to_string(counts.steps),
                                      std::to_string(counts.evaluations),
                                      std::to_string(counts.iterations),
                                      std::to_string(counts.corrections),
                                      std::to_string(counts.unconverged),
                                      to_exact_text(run.time()),
                                      std::to_string(run.seconds.size())};
      for (int k = 0; k < kNorms; ++k) {
        const Norm norm = static_cast<Norm>(k);
        const double error = run.errors[norm];
        row.push_back(run.ending != RunEnding::finished || std::isnan(error) ? ""
                      : error < study.floors[norm] ? "below " + to_exact_text(study.floors[norm])
                                                   : to_exact_text(error));
      }
      row.push_back(space ? to_exact_text(*space) : "");
      table.rows.push_back(std::move(row));
    }
  return table;
}

}  // namespace hair
