#include "hair/lab/head/head_record.h"

namespace hair::head_study {
namespace {

Row row_of_case(const HeadCase& one) {
  return {{"hair", "", one.hair->id},
          {"head", "", one.collides},
          {"simulated_by", "", "exercises"},
          {"strands", "", one.strands},
          {"points", "", one.hair->points, In::json},
          {"length", "m", one.length},
          {"seconds", "", one.seconds, In::json}};
}

OrderedJson json_of_run(const GuideRun& run) {
  OrderedJson modes;
  for (std::size_t m = 0; m < kModes.size(); ++m) modes[kModes[m].id] = json_of(row_of_mode(run.modes[m]));
  return {{"guides", run.guides}, {"simulation", run.simulation}, {"modes", modes}};
}

Row csv_row(const HeadCase& one, int guides, const char* mode, double simulation, const ModeRun& run) {
  return row_of_case(one) + Row{{"guides", "", guides}, {"mode", "", mode}, {"simulation", "s", simulation}} +
         row_of_mode(run);
}

}  // namespace

Row row_of_mode(const ModeRun& run) {
  const HeadErrors& e = run.errors;
  return {{"synthesis", "s", run.synthesis, In::files},
          {"start.rms", "m", e.start.rms, {"start", 1e3}},
          {"start.most", "m", e.start.most, {"start, 95 %", 1e3}},
          {"end.rms", "m", e.end.rms, {"end", 1e3}},
          {"end.most", "m", e.end.most, {"end, 95 %", 1e3}},
          {"all.rms", "m", e.all.rms, {"all", 1e3}},
          {"all.most", "m", e.all.most, {"all, 95 %", 1e3}},
          {"motion.rms", "m", e.motion.rms, {"motion", 1e3}},
          {"motion.most", "m", e.motion.most, {"motion, 95 %", 1e3}}};
}

OrderedJson head_json(const HeadStudy& study) {
  OrderedJson cases = OrderedJson::array(), pictures = OrderedJson::array();
  for (const HeadCase& one : study.cases) {
    OrderedJson runs = OrderedJson::array();
    for (const GuideRun& run : one.runs) runs.push_back(json_of_run(run));
    cases.push_back(json_of(row_of_case(one)));
    cases.back()["runs"] = runs;
  }
  for (const HeadPicture& one : study.pictures)
    pictures.push_back({{"hair", one.hair}, {"file", one.file}, {"guides", one.guides}});
  return {{"format", 1},
          {"frames_per_second", kFramesPerSecond},
          {"steps_per_frame", kStepsPerFrame},
          {"moving", kMoving},
          {"cases", cases},
          {"pictures", pictures},
          {"no_pictures", Value(if_any(study.no_pictures)).json()}};
}

std::vector<Row> head_rows(const HeadStudy& study) {
  std::vector<Row> rows;
  for (const HeadCase& one : study.cases) {
    for (const GuideRun& run : one.runs)
      for (std::size_t m = 0; m < kModes.size(); ++m)
        rows.push_back(csv_row(one, run.guides, kModes[m].id, run.simulation, run.modes[m]));
    rows.push_back(csv_row(one, one.strands, "none", one.seconds, {}));
  }
  return rows;
}

}  // namespace hair::head_study
