// Detects strips of a control mesh that are too thick: they push hair from the start on, each particle at
// many places, and a step may take seconds.
#pragma once

#include <optional>
#include <string>

#include "hair/scene/scene.h"

namespace hair {

// A warning if strips push at more places than there are particles before the first step. Calls H9.
std::optional<std::string> too_thick_strips(const Scene& scene);

}  // namespace hair
