// STAFF ONLY. Makes soft problems and their studies.
#include "studies.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "hair/lab/study/study_record.h"

namespace reference_tests {

hair::Study Studied::empty() const {
  hair::Study study = hair::prepare_study(problem, methods, settings);
  hair::set_reference(problem, motion, study);
  return study;
}

hair::Study Studied::whole() const {
  hair::Study study = empty();
  hair::finish_study(problem, motion, settings, study, false);
  return study;
}

Studied studied(const char* scene, double duration, const std::vector<std::string>& methods,
                double most_work) {
  Studied made;
  made.problem = hair::make_problem(hair::parse_scene(scene, "test"), {0, duration, {}});
  made.motion = hair::accurate_motion(made.problem, {}, false).value();
  for (const hair::StudyMethod& method : hair::methods_for(made.problem))
    if (std::find(methods.begin(), methods.end(), method.id) != methods.end()) made.methods.push_back(method);
  if (made.methods.size() != methods.size()) throw std::invalid_argument("a method is missing");
  made.settings.most_work = most_work;
  made.settings.repeats = {.most = 1, .enough = 0, .least = 1, .too_long = 0, .warm = 0};
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
