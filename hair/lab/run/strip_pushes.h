// Strips of a control mesh that are too thick: they push hair from the start on, each particle at many
// places, and a step may take seconds.
#pragma once

#include <optional>
#include <string>

#include "hair/scene/scene.h"

namespace hair {

// A line that says so, if strips push at more places than there are particles, before anything moves. Calls
// H9.
std::optional<std::string> too_thick_strips(const Scene& scene);

}  // namespace hair
