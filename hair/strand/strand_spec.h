// A strand as a scene describes it, before a model divides it into particles, links or elements.
#pragma once

#include <optional>
#include <variant>

#include "hair/strand/material.h"
#include "hair/strand/rest_shape.h"

namespace hair {

// The fibre of a strand; the factors make it stiffer or softer than its material.
struct Fibre {
  Material material;
  double stretch_factor = 1;  // factor of EA
  double bend_factor = 1;     // factor of EI
  double twist_factor = 1;    // factor of GJ
  double skip_factor = 0;     // factor of EA: the rigidity of springs that skip a particle
  // s, >= 0: the strand also resists the rates of bends and twists, with this times their stiffness.
  double relaxation_time = 0;
  // rad, > 0: the largest turn of a joint between two elements from its rest; none: any turn.
  std::optional<double> joint_limit = {};
};

// The rest curve.
struct Straight {};
struct Wavy {
  double amplitude, wavelength;  // m: see wavy_shape
};
struct Curly {
  double radius, pitch;  // m: see curly_shape
};
struct Drawn {
  Eigen::VectorXd x;  // m, 3n: a groom's points; it has an element for each piece between them
};
using RestForm = std::variant<Straight, Wavy, Curly, Drawn>;

bool is_wave_or_curl(const RestForm& form);

// The initial shape of a strand that does not start at rest: straight in a direction, with every segment
// `stretch` times as long, or folded back and forth; and its rotation about its root.
struct Held {
  bool differently = false;
  Vector3d direction = Vector3d::Zero();
  double stretch = 1;
  bool folded = false;
  Vector3d spin = Vector3d::Zero();  // rad/s
};

struct StrandSpec {
  Fibre fibre;
  RestForm form;
  double length = 0.1;  // m, > 0
  int elements = 10;    // segments, links, helices: >= 1
  RootFrame root;
  bool clamped = true;
  Held start;
  Vector3d root_velocity = Vector3d::Zero();  // m/s
};

// Throws std::invalid_argument as straight_shape, wavy_shape and curly_shape do. A drawn strand leaves its
// root along its first piece.
RestShape rest_shape(const StrandSpec& spec);

// The start of the rest curve, with its tangent and normal; curls may be too tight for the elements.
RestShape root_of_curve(const StrandSpec& spec);

// The same strand, in as many elements as segments need to follow its curve, if it has fewer.
StrandSpec finely_divided(const StrandSpec& spec);

// The curve's curvature and torsion, 1/m, at the arc length s from its root. They refer to the frame that
// starts with the tangent and the normal of rest_shape and turns with the torsion; curvature is towards this
// normal. A planar curve has a curvature of either sign and no torsion; a helix bends towards its own axis,
// away from the normal, with constant curvature and torsion. Drawn strands have points, and no such curve:
// throws std::invalid_argument.
struct Bend {
  double curvature = 0, torsion = 0;
};
Bend bend_at(const RestForm& form, double s);

}  // namespace hair
