#include "hair/lab/head/head_record.h"

#include <nlohmann/json.hpp>

namespace hair::head_study {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const HeadError& error) {
  return {{"rms", error.rms}, {"most", error.most}};
}

Json json_of(const GuideRun& run) {
  Json modes = Json::object();
  for (std::size_t m = 0; m < kModes.size(); ++m) {
    const HeadErrors& errors = run.modes[m].errors;
    modes[kModes[m].id] = {{"synthesis", run.modes[m].synthesis},
                           {"start", json_of(errors.start)},
                           {"end", json_of(errors.end)},
                           {"all", json_of(errors.all)},
                           {"motion", json_of(errors.motion)}};
  }
  return {{"guides", run.guides}, {"simulation", run.simulation}, {"modes", modes}};
}

const char* simulated_by(const HeadCase& one) {
  return one.fast ? "engine" : "exercises";
}

}  // namespace

std::string head_json(const HeadStudy& study, const std::string& machine) {
  Json json = {{"program", "hairlab study head"},
               {"format", 1},
               {"quick", study.quick},
               {"threads", study.threads},
               {"machine", machine},
               {"frames_per_second", kFramesPerSecond},
               {"steps_per_frame", kStepsPerFrame},
               {"moving", kMoving},
               {"cases", Json::array()},
               {"pictures", Json::array()},
               {"no_pictures", study.no_pictures.empty() ? Json(nullptr) : Json(study.no_pictures)}};
  for (const HeadCase& one : study.cases) {
    Json runs = Json::array();
    for (const GuideRun& run : one.runs) runs.push_back(json_of(run));
    json["cases"].push_back({{"hair", one.hair->id},
                             {"head", one.collides},
                             {"simulated_by", simulated_by(one)},
                             {"strands", one.strands},
                             {"points", one.hair->points},
                             {"length", one.length},
                             {"seconds", one.seconds},
                             {"runs", runs}});
  }
  for (const HeadPicture& picture : study.pictures)
    json["pictures"].push_back({{"hair", picture.hair}, {"file", picture.file}, {"guides", picture.guides}});
  return json.dump(2) + "\n";
}

Table table_of_runs(const HeadStudy& study) {
  Table table{"",
              {"hair", "head", "simulated_by", "strands", "length_m", "guides", "synthesis", "simulation_s",
               "synthesis_s", "start_rms_m", "end_rms_m", "end_95_m", "all_rms_m", "all_95_m", "motion_rms_m",
               "motion_95_m"},
              {}};
  for (const HeadCase& one : study.cases) {
    const std::vector<std::string> first = {one.hair->id, one.collides ? "yes" : "no", simulated_by(one),
                                            std::to_string(one.strands), to_exact_text(one.length)};
    const auto add = [&](int guides, const char* mode, double simulation, const ModeRun& run) {
      std::vector<std::string> row = first;
      row.insert(row.end(), {std::to_string(guides), mode});
      const HeadErrors& e = run.errors;
      for (const double number : {simulation, run.synthesis, e.start.rms, e.end.rms, e.end.most, e.all.rms,
                                  e.all.most, e.motion.rms, e.motion.most})
        row.push_back(to_exact_text(number));
      table.rows.push_back(std::move(row));
    };
    for (const GuideRun& run : one.runs)
      for (std::size_t m = 0; m < kModes.size(); ++m)
        add(run.guides, kModes[m].id, run.simulation, run.modes[m]);
    add(one.strands, "none", one.seconds, {});
  }
  return table;
}

}  // namespace hair::head_study
