// Plays a scene and writes the results into a folder: states, measures, pictures, a film.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "hair/lab/run/run_record.h"
#include "hair/scene/scene.h"
#include "hair/view/motion.h"

namespace hair {

struct RunSettings {
  std::filesystem::path out;
  std::optional<int> frames;  // after the first one; overrides the scene's number
  bool render = true;         // if the scene has a look
  bool draws =
      false;  // without pictures, too, the page shows dense hair, which needs H10; `render` says so as well
  std::size_t most_points = kMostPointsShown;  // of the page, in all frames: more leave strands out
  // Strands that the page leaves out are not simulated, where none moves another or makes dense hair;
  // energies, which would be of some strands alone, are left out, too.
  bool only_shown = false;
  double read_seconds = 0;  // what it took to read the scene
};

struct RunResult {
  RunRecord record;
  std::filesystem::path folder;
};

// Throws BadInput for errors of the scene or the folder, and passes on exceptions of stubs; the folder is
// then unchanged. `interrupted` ends the run after the present frame; the result is a complete run of fewer
// frames. Writes messages for the user, one line each, to `notes`, and the progress to `progress` unless it
// is null.
RunResult run_scene(const Scene& scene, const RunSettings& settings, const std::atomic<bool>& interrupted,
                    std::ostream& notes, std::ostream* progress);

}  // namespace hair
