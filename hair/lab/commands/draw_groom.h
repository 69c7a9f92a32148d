// `hairlab draw` without its command line: a picture of a groom as it is, without simulation.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "hair/head/head.h"
#include "hair/render/drawing.h"

namespace hair {

struct DrawOptions {
  std::filesystem::path file, picture;
  std::string colour = "brown", on = "bust";  // or "ellipsoid", "none"
  double unit = 0;   // m; 0: a size that fits the head that it is on, or an average head
  double turn = 0;   // degrees about z
  double width = 0;  // m, of a strand; 0: chosen so that the strands cover a head
  std::array<double, 3> view = {0.6, -1, 0.15};
  double zoom = 1;
  std::array<int, 2> size = {1280, 720};  // pixels
  bool no_shadows = false;
};

// The program's exit code.
int draw_groom(const DrawOptions& options);

// The place of a groom on a head: each point x goes to scale x + move.
struct GroomFit {
  double scale = 1;
  Vector3d move = Vector3d::Zero();
};

// The fit with the least sum of squared distances of the roots from the head's surface. The search starts
// with the box of the roots on the box of the scalp. `unit`: the scale, if it is given. Throws
// std::invalid_argument for fewer than 4 roots, or roots that are all in one place.
GroomFit fit_to_head(const std::vector<Vector3d>& roots, const Head& head, std::optional<double> unit);

}  // namespace hair
