// STAFF ONLY. Makes soft problems and their studies.
#include "hair/lab/study/test_studies.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "hair/lab/study/study_record.h"

namespace reference_tests {

Studied studied(const char* scene, double duration, const std::vector<std::string>& methods,
                double most_work) {
  Studied made{hair::make_problem(hair::parse_scene(scene, "test"), {0, duration, {}}), {}};
  std::vector<hair::StudyMethod> chosen = hair::methods_for(made.problem);
  std::erase_if(chosen, [&](const hair::StudyMethod& method) {
    return std::ranges::find(methods, method.id) == methods.end();
  });
  if (chosen.size() != methods.size()) throw std::invalid_argument("a method is missing");
  hair::StudySettings settings;
  settings.most_work = most_work;
  settings.repeats = {.most = 1, .enough = 0, .least = 1, .too_long = 0, .warm = 0};
  made.study = hair::prepare_study(made.problem, chosen, settings,
                                   hair::accurate_motion(made.problem, {}, false).value());
  hair::finish_study(made.problem, settings, made.study, false);
  return made;
}

const hair::Sweep& sweep_of(const hair::Study& study, const std::string& id) {
  for (const hair::Sweep& sweep : study.sweeps)
    if (sweep.method.id == id) return sweep;
  throw std::invalid_argument("no method " + id);
}

std::string shown(const hair::Sweep& sweep) {
  std::ostringstream text;
  text << sweep.method.name << ", " << hair::name_of(sweep.end) << "\n";
  for (const hair::MethodRun& run : sweep.runs)
    text << "  h = " << run.step << " s: " << hair::name_of(run.ending) << " " << run.trouble
         << ", trajectory " << run.errors[hair::Norm::trajectory] << " m\n";
  return text.str();
}

}  // namespace reference_tests
