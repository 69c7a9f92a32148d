#include <cmath>
#include <stdexcept>

#include "hair/scene/json/fibre.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"
#include "hair/scene/roots.h"

namespace hair::json {

namespace {

// A strand of a groom as a shape at rest, which its first segment leaves the root with.
RestShape shape_of(const Eigen::VectorXd& points, double scale, const Vector3d& move) {
  RestShape shape{scale * points, {}, {}};
  for (Eigen::Index k = 0; k < shape.x.size(); k += 3) shape.x.segment<3>(k) += move;
  shape.tangent = (shape.x.segment<3>(3) - shape.x.head<3>()).normalized();
  shape.normal = side_of(shape.tangent);
  return shape;
}

// Joints bend by less than kMostRest, or they would forget it.
bool can_rest(const StrandStart& start) {
  const Eigen::VectorXd& bends = start.rest_curvature;
  for (Eigen::Index i = 0; i + 1 < bends.size(); i += 2)
    if (!(bends.segment<2>(i).norm() <= kMostRest)) return false;
  return true;
}

}  // namespace

void read_groom(const JsonValue& group, Reading& reading) {
  group.check_keys({"groom"}, {"material", "clamped", "start", "root_velocity", "moves_with"});
  const JsonValue groom = group["groom"];
  groom.check_keys({"file", "scale"}, {"every", "move"});
  const double scale = groom["scale"].number(1e-6, 1e6);
  const Vector3d move = vector_or(groom, "move", Vector3d::Zero(), kFar);
  const long every = groom.has("every") ? groom["every"].whole_number(1, kMostParticles) : 1;
  const Fibre fibre = read_fibre(group);
  const Held held = read_held(group);
  const bool clamped = boolean_or(group, "clamped", true);
  const Vector3d velocity = read_root_velocity(group);
  Rider* const rider = reading.rider(group);

  if (!reading.groom) groom["file"].fail("this scene can't have files of its own; leave the groom out");
  const std::vector<Eigen::VectorXd> points = reading.groom(groom["file"]);
  std::vector<StrandStart>& strands = reading.scene.hair.strands;
  for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(every)) {
    const std::string which = "strand " + std::to_string(i) + " of the groom: ";
    reading.expect(groom, 1, points[i].size() / 3);
    if (!(scale * points[i].cwiseAbs().maxCoeff() <= kFar))
      groom["scale"].fail(which + "is farther than 1e+06 m; give a smaller one");
    if (rider) rider->strands.push_back(static_cast<int>(strands.size()));
    try {
      StrandStart& start =
          strands.emplace_back(start_at_rest(fibre, shape_of(points[i], scale, move), false, clamped));
      if (!can_rest(start)) groom.fail(which + "bends by more than 154 degrees; no hair rests so");
      hold(held, start);
      start.state.v.head<3>() = velocity;
    } catch (const std::invalid_argument& error) {
      groom.fail(which + error.what());
    }
  }
}

}  // namespace hair::json
