// The last picture of a run that broke.
#pragma once

#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace hair {

// Makes a strand red, thick and visible: points outside of the view are brought to its border. `strand`: its
// place in the drawing; there is none of that number where dense hair is drawn.
void mark_broken(Drawing& drawing, int strand, const Camera& camera, double aspect);

}  // namespace hair
