#include "hair/lab/study/study_record.h"

#include <algorithm>
#include <cmath>

namespace hair {

namespace {

constexpr std::array<const char*, 3> kEndings = {"finished", "broke", "useless"};
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

// An error in a table; empty if there is none.
std::string written(const Study& study, const MethodRun& run, Norm norm, std::string (*number)(double)) {
  const double error = run.errors[norm];
  if (run.ending != RunEnding::finished || std::isnan(error)) return "";
  return error < study.floors[norm] ? "below " + number(study.floors[norm]) : number(error);
}

}  // namespace

const char* name_of(RunEnding ending) {
  return kEndings[static_cast<int>(ending)];
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
  const bool finished = std::ranges::none_of(
      study.sweeps, [](const Sweep& sweep) { return sweep.end == SweepEnd::unfinished; });
  OrderedJson json = {
      {"program", "hairlab study"},
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
      {"reference",
       {{"method", study.reference.method},
        {"agreement", study.reference.agreement},
        {"least_error", study.reference.least_error()},
        {"inextensible", study.reference.inextensible},
        {"from_cache", study.reference.from_cache},
        {"seconds", study.reference.cpu_seconds}}},
      {"floors", json_of(study.floors, [&](Norm norm) { return OrderedJson(study.floors[norm]); })},
      {"space_error", json_of(study.space_error)},
      {"methods", json_of(rows_of(study.sweeps, row_of_sweep))}};
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
