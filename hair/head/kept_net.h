// Surface nets that are kept in a file: a bust's takes seconds to make. A file contains its key, which
// depends on the solid's own values, and ends with a digest of itself. One with another key, cut short or
// changed, is ignored.
#pragma once

#include <filesystem>
#include <optional>

#include "hair/head/surface_net.h"

namespace hair {

// surface_net(solid, cells), from a file of this folder. Otherwise it is made, and kept there if there is a
// folder that can be written.
SurfaceMesh kept_surface_net(const Solid& solid, int cells,
                             const std::optional<std::filesystem::path>& folder);

}  // namespace hair
