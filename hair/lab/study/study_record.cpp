#include "hair/lab/study/study_record.h"

#include <algorithm>
#include <cmath>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/strict_json.h"

namespace hair {

namespace {

constexpr double kMost = 1e300;
constexpr long kMostCount = 1L << 52;

constexpr std::array<std::string_view, 3> kEndings = {"finished", "broke", "useless"};
constexpr std::array<const char*, 5> kSweepEnds = {"unfinished", "below the reference's floor",
                                                   "smaller steps make no difference",
                                                   "the next would take too long", "not written"};

// The values of the norms that the problem has.
OrderedJson json_of(const Errors& errors, const std::function<OrderedJson(Norm)>& value) {
  OrderedJson json = OrderedJson::object();
  for (const Norm norm : all_norms())
    if (!std::isnan(errors[norm])) json[name_of(norm).id] = value(norm);
  return json;
}

Row row_of_sweep(const Sweep& sweep) {
  return {{"id", "", sweep.method.id},         {"name", "", sweep.method.name},
          {"order", "", sweep.method.order()}, {"explicit", "", sweep.method.is_explicit()},
          {"end", "", name_of(sweep.end)},     {"left_out", "", sweep.left_out}};
}

OrderedJson json_of(const std::optional<SpaceError>& space) {
  if (!space) return nullptr;
  if (!space->left_out.empty()) return {{"left_out", space->left_out}};
  return {{"levels", json_of(rows_of(space->levels, row_of_level))},
          {"order", space->order},
          {"time_error", space->time_error},
          {"stretch", space->stretch},
          {"seconds", space->cpu_seconds}};
}

Errors read_errors(const JsonValue& json) {
  Errors errors;
  for (const Norm norm : all_norms()) {
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
  run.ending = static_cast<RunEnding>(json["ending"].word(kEndings));
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

// Each run has half the step of the previous one.
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

// Everything except the runs.
OrderedJson head_of(const Study& study) {
  const bool finished = std::none_of(study.sweeps.begin(), study.sweeps.end(),
                                     [](const Sweep& sweep) { return sweep.end == SweepEnd::unfinished; });
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
          {"machine",
           {{"processor", study.machine.processor},
            {"cores", study.machine.cores},
            {"compiler", study.machine.compiler},
            {"build", study.machine.build},
            {"eigen", study.machine.eigen}}},
          {"program_digest", study.program_digest},
          {"reference",
           {{"method", study.reference},
            {"agreement", study.agreement},
            {"least_error", study.least_error},
            {"inextensible", study.inextensible},
            {"from_cache", study.from_cache},
            {"seconds", study.reference_seconds}}},
          {"floors", json_of(study.floors, [&](Norm norm) { return OrderedJson(study.floors[norm]); })},
          {"space_error", json_of(study.space_error)},
          {"methods", json_of(rows_of(study.sweeps, row_of_sweep))}};
}

// An error in a table; empty if there is none.
std::string written(const Study& study, const MethodRun& run, Norm norm, std::string (*number)(double)) {
  const double error = run.errors[norm];
  if (run.ending != RunEnding::finished || std::isnan(error)) return "";
  return error < study.floors[norm] ? "below " + number(study.floors[norm]) : number(error);
}

// The part of a record that must be equal when a study resumes: all except the runs, the reference's time,
// and whether it is finished; with the values that follow from the reference, if that is known.
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
  return kEndings[static_cast<int>(ending)].data();
}

const char* name_of(SweepEnd end) {
  return kSweepEnds[static_cast<int>(end)];
}

Row row_of_level(const SpaceLevel& level) {
  return {{"segments", "", level.segments}, {"error", "m", level.error}};
}

bool has(const Study& study, Norm norm) {
  for (const Sweep& sweep : study.sweeps)
    for (const MethodRun& run : sweep.runs)
      if (run.ending == RunEnding::finished) return !std::isnan(run.errors[norm]);
  return false;
}

Row row_of_run(const Study& study, const MethodRun& run) {
  const Counts& counts = run.counts;
  Row row = {{"steps_per_moment", "", run.steps_per_moment, In::files},
             {"step", "s", run.step},
             {"ending", "", name_of(run.ending), In::files},
             {"trouble", "", run.trouble, In::files},
             {"steps", "", counts.steps},
             {"evaluations", "", counts.evaluations},
             {"iterations", "", counts.iterations},
             {"corrections", "", counts.corrections, In::files},
             {"unconverged", "", counts.unconverged},
             {"time", "s", run.time(), {"CPU time, s"}},
             {"repeats", "", run.seconds.size(), In::tables},
             {"seconds", "", run.seconds, In::json}};
  for (const Norm norm : all_norms()) {
    row.push_back({name_of(norm).id, name_of(norm).unit, written(study, run, norm, to_exact_text), In::csv});
    if (has(study, norm))
      row.push_back({"", "", written(study, run, norm, to_text), {with_unit(name_of(norm))}, In::page});
  }
  return row;
}

OrderedJson study_json(const Study& study) {
  OrderedJson json = head_of(study);
  for (std::size_t i = 0; i < study.sweeps.size(); ++i) {
    OrderedJson& runs = json["methods"][i]["runs"] = OrderedJson::array();
    for (const MethodRun& run : study.sweeps[i].runs) {
      runs.push_back(json_of(row_of_run(study, run)));
      if (run.ending == RunEnding::finished)
        runs.back()["errors"] = json_of(run.errors, [&](Norm norm) {
          return run.errors[norm] < study.floors[norm] ? OrderedJson() : OrderedJson(run.errors[norm]);
        });
    }
  }
  return json;
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

std::vector<Row> run_rows(const Study& study) {
  std::optional<double> space;
  if (study.space_error) space = study.space_error->error_of(study.particles - 1);
  std::vector<Row> rows;
  for (const Sweep& sweep : study.sweeps)
    for (const MethodRun& run : sweep.runs)
      rows.push_back(
          Row{{"method", "", sweep.method.id, In::csv}, {"method", "", sweep.method.name, In::page}} +
          row_of_run(study, run) + Row{{"space_error", "m", space, In::csv}});
  return rows;
}

}  // namespace hair
