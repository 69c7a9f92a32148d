// Runs a scene and writes the results into a folder: states, measures, pictures, a film.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <ostream>

#include "hair/lab/run/run_record.h"
#include "hair/scene/scene.h"
#include "hair/view/motion.h"

namespace hair {

struct RunSettings {
  std::filesystem::path out;
  std::optional<int> frames;                   // after the first one; overrides the scene's number
  bool render = true;                          // if the scene has a look
  std::size_t most_points = kMostPointsShown;  // for the page, in all frames: more points leave strands out
  // For a page without pictures. It shows dense hair, which calls H10; strands that it leaves out are not
  // simulated, if none moves another or makes dense hair. Energies of some strands alone would mislead and
  // are left out, too.
  bool for_page = false;
  double read_seconds = 0;  // the time that reading the scene took
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
