// STAFF ONLY. Lists the learning systems, a row each.
#include <algorithm>

#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

const std::vector<System>& systems() {
  static const std::vector<System> all{
      {.name = "gradescope",
       .shown = "Gradescope",
       .example = "submission_31415926/, beside submission_metadata.yml",
       .read = read_gradescope},
      {.name = "moodle",
       .shown = "Moodle",
       .example = "Jane Doe_4711_assignsubmission_file/",
       .read = read_moodle,
       .settle = settle_moodle},
      {.name = "brightspace",
       .shown = "Brightspace",
       .example = "5917-716031 - Jane Doe - May 18, 2025 1224 PM/",
       .read = read_brightspace,
       .settle = settle_brightspace},
      {.name = "blackboard",
       .shown = "Blackboard",
       .example = "Lab 3_so12_attempt_2025-03-04-10-15-22_main.cpp",
       .read = read_blackboard,
       .settle = settle_blackboard},
      {.name = "autolab", .shown = "Autolab", .example = "joerg@u.de_3_lab.tar", .read = read_autolab},
      {.name = "canvas",
       .shown = "Canvas",
       .example = "doejane_4711_90001_main.cpp",
       .read = read_canvas,
       .settle = settle_canvas,
       .files_have_versions = true},
      {.name = "classroom",
       .shown = "GitHub Classroom",
       .example = "lab3-submissions/lab3-jmueller/",
       .read = read_classroom,
       .settle = settle_classroom},
  };
  return all;
}

std::vector<std::string> layout_names() {
  std::vector<std::string> names;
  for (const System& system : systems()) names.emplace_back(system.name);
  names.emplace_back("folders");
  return names;
}

const System* system_called(std::string_view name) {
  const auto found = std::ranges::find(systems(), name, &System::name);
  return found == systems().end() ? nullptr : &*found;
}

void settle_readings(NamedPath& named, std::string_view system, const KnownOwner& known) {
  if (named.others.empty() || !known) return;
  int best = known(named.owner, system);
  const NamedPath* taken = &named;
  bool alone = best > 0;
  for (const NamedPath& other : named.others) {
    const int well = known(other.owner, system);
    if (well == best) alone = false;
    if (well <= best) continue;
    best = well;
    taken = &other;
    alone = true;
  }
  if (!alone) return;
  const bool proven = best > 1 || taken == &named;
  NamedPath settled = *taken;
  settled.doubt = proven ? "" : named.doubt + "; this roster has the number's owner, and no such group";
  named = std::move(settled);
}

std::optional<Told> told_by_name(std::string_view name, bool is_folder, const KnownOwner& known) {
  for (const System& system : systems()) {
    std::optional<NamedPath> named = system.read(name, is_folder, {});
    if (!named || named->kind == NamedPath::Kind::made || system.name == "gradescope") continue;
    if (system.settle) {
      std::vector<NamedPath*> alone{&*named};
      system.settle(alone);
    }
    settle_readings(*named, system.name, known);
    return Told{&system, std::move(*named)};
  }
  return {};
}

}  // namespace grader::intake
