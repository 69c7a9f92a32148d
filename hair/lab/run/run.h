// Plays a scene, and writes what it does into a folder: states, measures, pictures, a film.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "hair/lab/run/run_record.h"
#include "hair/scene/scene.h"

namespace hair {

struct RunSettings {
  std::filesystem::path out;
  std::optional<int> frames;  // after the first, instead of the scene's
  bool render = true;         // if the scene has a look
};

struct RunResult {
  RunRecord record;
  std::filesystem::path folder;
};

// Throws BadInput for what the scene or the folder is; what a stub throws, passes; the folder is then as it
// was before. `interrupted` ends it after the present frame, as a whole run of fewer frames. What a person
// should know, a line each, goes to `notes`; how far it is, to `progress`, if that is not null.
RunResult run_scene(const Scene& scene, const RunSettings& settings, const std::atomic<bool>& interrupted,
                    std::ostream& notes, std::ostream* progress);

}  // namespace hair
