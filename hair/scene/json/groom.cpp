#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hair/scene/json/fibre.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

// Its first point that is where the point before it is; 0: none.
Eigen::Index first_without_length(const Eigen::VectorXd& x) {
  for (Eigen::Index k = 3; k < x.size(); k += 3)
    if (x.segment<3>(k) == x.segment<3>(k - 3)) return k / 3;
  return 0;
}

// Joints bend by less than kMostRest, or they would forget it.
bool can_rest(const Eigen::VectorXd& x) {
  for (Eigen::Index k = 0; k + 6 < x.size(); k += 3) {
    const Vector3d before = x.segment<3>(k + 3) - x.segment<3>(k);
    const Vector3d after = x.segment<3>(k + 6) - x.segment<3>(k + 3);
    if (!(std::atan2(before.cross(after).norm(), before.dot(after)) <= kMostRest)) return false;
  }
  return true;
}

void set_points(Eigen::VectorXd x, StrandSpec& spec) {
  spec.elements = static_cast<int>(x.size() / 3) - 1;
  spec.length = 0;
  for (Eigen::Index k = 3; k < x.size(); k += 3)
    spec.length += (x.segment<3>(k) - x.segment<3>(k - 3)).norm();
  spec.root.position = x.head<3>();
  spec.form = Drawn{std::move(x)};
}

}  // namespace

void read_groom(const JsonValue& group, Reading& reading) {
  group.check_keys({"groom"}, {"model", "material", "clamped", "start", "root_velocity", "moves_with"});
  const JsonValue groom = group["groom"];
  groom.check_keys({"file", "scale"}, {"every", "move"});
  const double scale = groom["scale"].number(1e-6, 1e6);
  const Vector3d move = vector_or(groom, "move", Vector3d::Zero(), kFar);
  const long every = groom.has("every") ? groom["every"].whole_number(1, kMostParticles) : 1;
  const ModelRow& model = *read_model(group);
  StrandSpec spec;
  spec.fibre = read_fibre(group);
  spec.start = read_held(group);
  spec.clamped = boolean_or(group, "clamped", true);
  spec.root_velocity = read_root_velocity(group);
  Rider* const rider = reading.rider(group);

  if (!reading.groom) groom["file"].fail("this scene can't have files of its own; leave the groom out");
  const std::vector<Eigen::VectorXd> points = reading.groom(groom["file"]);
  Description& hair = reading.scene.hair;
  const std::size_t before = hair.strands.size() + hair.modelled.size();
  for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(every)) {
    const std::string which = "strand " + std::to_string(i) + " of the groom: ";
    if (points[i].size() == 3) {
      ++reading.scene.bald_roots;
      continue;
    }
    reading.expect(groom, 1, points[i].size() / 3);
    if (const Eigen::Index point = first_without_length(points[i]))
      groom["file"].fail(which + "its point " + std::to_string(point) +
                         " is where the point before it is; a segment has a length");
    if (!(scale * points[i].cwiseAbs().maxCoeff() <= kFar))
      groom["scale"].fail(which + "is farther than 1e+06 m; give a smaller one");
    if (rider) rider->strands.push_back(static_cast<int>(hair.strands.size() + hair.modelled.size()));
    Eigen::VectorXd x = scale * points[i];
    for (Eigen::Index k = 0; k < x.size(); k += 3) x.segment<3>(k) += move;
    if (!can_rest(x)) groom.fail(which + "bends by more than 154 degrees; no hair rests so");
    try {
      set_points(std::move(x), spec);
      add_strand(model, spec, hair);
    } catch (const std::invalid_argument& error) {
      groom.fail(which + error.what());
    }
  }
  if (hair.strands.size() + hair.modelled.size() == before)
    groom["file"].fail("all strands that are taken are bald roots, of a single point");
}

}  // namespace hair::json
