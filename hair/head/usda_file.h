// Grooms as USD text, .usda: one prim of BasisCurves. Written only. Source: Pixar, "UsdGeomBasisCurves",
// openusd.org.
//
// Has points, widths and colours (of each point where the groom has them), and opacity; what is not known of them is not
// there. The digits of a number are as few as give its 32 bits again. Loses bald roots, and the text of a .hair file.
#pragma once

#include <string>

#include "hair/head/groom.h"

namespace hair {

struct UsdaSettings {
  bool cubic = false;   // Catmull-Rom splines through all points, pinned at both ends; else straight pieces
  double unit = 1;      // metersPerUnit: metres that the groom's unit has
  bool z_is_up = true;  // else y
};

// Throws BadInput for a groom that can't be written (groom_bytes.h); a strand has two points at least.
std::string usda_file_of(const Groom& groom, const UsdaSettings& settings = {});

}  // namespace hair
