// The last picture of a run that broke.
#pragma once

#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace hair {

// Makes a strand red, thick and visible: moves points outside of the view to its border. `strand`: its index
// in the drawing; dense hair has no such index.
void mark_broken(Drawing& drawing, int strand, const Camera& camera, double aspect);

}  // namespace hair
