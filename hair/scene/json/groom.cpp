#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/head/farthest_points.h"
#include "hair/head/grow.h"
#include "hair/head/resample.h"
#include "hair/head/scalp_roots.h"
#include "hair/scene/json/fibre.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

constexpr long kMostPicked = 5000, kMostPoints = 10'000;

// What a groom brings: strands in metres, and the scalp that they grow on.
struct Strands {
  std::vector<Eigen::VectorXd> points;
  std::vector<std::string> names;  // of each, for errors
  GroupScalp scalp;                // if the group has dense hair
};

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

RootFrame root_of(const Eigen::VectorXd& x) {
  const Vector3d way = x.segment<3>(3) - x.head<3>();
  const Vector3d axis = way.norm() > 0 ? Vector3d(way.normalized()) : Vector3d(Vector3d::UnitZ());
  return {x.head<3>(), axis, side_of(axis)};
}

void check_strand(const JsonValue& groom, const std::string& which, const Eigen::VectorXd& x, double scale) {
  if (const Eigen::Index point = first_without_length(x))
    groom["file"].fail(which + "its point " + std::to_string(point) +
                       " is where the point before it is; a segment has a length");
  if (!(scale * x.cwiseAbs().maxCoeff() <= kFar))
    groom["scale"].fail(which + "is farther than 1e+06 m; give a smaller one");
  if (!can_rest(x)) groom.fail(which + "bends by more than 154 degrees; no hair rests so");
}

bool is_hair(const Eigen::VectorXd& x, double scale) {
  return !first_without_length(x) && scale * x.cwiseAbs().maxCoeff() <= kFar && can_rest(x);
}

// Strands of a file, without bald roots.
Strands of_file(const JsonValue& groom, bool dense, Reading& reading) {
  groom.check_keys({"file", "scale"}, {"every", "strands", "points", "move"});
  const double scale = groom["scale"].number(1e-6, 1e6);
  const Vector3d move = vector_or(groom, "move", Vector3d::Zero(), kFar);
  const long every = groom.has("every") ? groom["every"].whole_number(1, kMostParticles) : 1;
  const long points = groom.has("points") ? groom["points"].whole_number(2, kMostPoints) : 0;
  const long picked = groom.has("strands") ? groom["strands"].whole_number(1, kMostPicked) : 0;
  if (!reading.groom) groom["file"].fail("this scene can't have files of its own; leave the groom out");
  const std::vector<Eigen::VectorXd> all = reading.groom(groom["file"]);
  std::vector<std::size_t> hairs;  // in the file
  std::vector<RootFrame> roots;
  std::vector<Vector3d> places;
  for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(every)) {
    if (all[i].size() == 3) {
      ++reading.scene.bald_roots;
      continue;
    }
    hairs.push_back(i);
    roots.push_back(root_of(all[i]));
    roots.back().position = scale * roots.back().position + move;
    places.push_back(roots.back().position);
  }
  if (hairs.empty()) groom["file"].fail("all strands that are taken are bald roots, of a single point");

  Strands found;
  if (dense) found.scalp = scalp_of(roots);
  std::vector<RootFrame> guides;
  for (const std::size_t k :
       farthest_points(places, picked ? static_cast<std::size_t>(picked) : hairs.size())) {
    const Eigen::VectorXd& whole = all[hairs[k]];
    reading.expect(groom, 1, points ? points : whole.size() / 3);
    Eigen::VectorXd x = points ? resampled(whole, static_cast<int>(points)) : whole;
    // Of those that it picks the scene needs none in particular.
    if (picked && !is_hair(x, scale)) continue;
    found.names.push_back("strand " + std::to_string(hairs[k]) + " of the groom: ");
    check_strand(groom, found.names.back(), x, scale);
    x *= scale;
    for (Eigen::Index i = 0; i < x.size(); i += 3) x.segment<3>(i) += move;
    found.points.push_back(std::move(x));
    if (dense) guides.push_back(found.scalp.guides[k]);
  }
  if (found.points.empty())
    groom["file"].fail("none of the strands that are picked is hair; pick more of them");
  found.scalp.guides = std::move(guides);
  return found;
}

// Hair that grows on a head, in a style.
StillHair read_grown(const JsonValue& groom) {
  groom.check_keys({"style", "strands"}, {"points", "length", "head", "at", "seed"});
  std::vector<std::string_view> names;
  for (const HairStyle& style : hair_styles()) names.emplace_back(style.name);
  StillHair hair;
  hair.style = hair_styles()[groom["style"].word(names)];
  if (groom.has("length")) hair.style.length = length(groom["length"]);
  GrowSettings& settings = hair.settings;
  settings.strands = static_cast<int>(groom["strands"].whole_number(1, 100'000));
  settings.points = groom.has("points") ? static_cast<int>(groom["points"].whole_number(2, kMostPoints)) : 0;
  if (groom.has("seed")) settings.seed = static_cast<std::uint64_t>(groom["seed"].whole_number(0, 1L << 53));
  hair.at = vector_or(groom, "at", Vector3d::Zero(), kFar);
  if (groom.has("head") && groom["head"].word({"bust", "ellipsoid"}) == 1)
    hair.head = std::make_shared<EllipsoidHead>();
  else
    hair.head = std::make_shared<Bust>();
  return hair;
}

// Its strands.
Strands grown(const JsonValue& groom, bool dense, Reading& reading) {
  auto [head, at, style, settings, motion] = read_grown(groom);
  // Guides are in no clump: what is drawn of them gathers as wisps.
  if (dense) style.clump = 0, style.fly_aways = 0;
  reading.expect(groom["strands"], settings.strands, settings.points ? settings.points : style.points);
  Strands found;
  try {
    found.points = grow_groom(*head, style, settings).strands;
  } catch (const std::invalid_argument& error) {
    groom.fail(error.what());
  }
  for (Eigen::VectorXd& x : found.points) {
    found.names.push_back("strand " + std::to_string(found.names.size()) + ": ");
    RootFrame root = root_of(x);
    root.axis = head->surface_at(root.position).normal;
    root.side = head->combed(root.position);
    root.position += at;
    found.scalp.guides.push_back(root);
    for (Eigen::Index k = 0; k < x.size(); k += 3) x.segment<3>(k) += at;
  }
  found.scalp.combed = true;
  found.scalp.more = [head = head, at = at](int count, std::uint64_t seed) {
    std::vector<RootFrame> roots = scalp_roots(*head, count, seed);
    for (RootFrame& root : roots) root.position += at;
    return roots;
  };
  return found;
}

}  // namespace

void read_still_hair(const JsonValue& list, Reading& reading) {
  for (const JsonValue& object : list.items()) {
    object.check_keys({"groom"}, {"moves_with"});
    const JsonValue groom = object["groom"];
    StillHair hair = read_grown(groom);
    const int points = hair.settings.points > 0 ? hair.settings.points : hair.style.points;
    if (points < fewest_points(hair.style))
      groom["points"].fail("is too few to follow the style; give " +
                           std::to_string(fewest_points(hair.style)) + " at least");
    reading.dense_points += static_cast<long>(hair.settings.strands) * points;
    if (reading.dense_points > kMostDensePoints)
      groom["strands"].fail("makes " + std::to_string(reading.dense_points) +
                            " points in all; a scene draws at most " + std::to_string(kMostDensePoints));
    if (const Rider* rider = reading.rider(object)) hair.motion = rider->motion;
    reading.scene.still.push_back(std::move(hair));
  }
}

void read_groom(const JsonValue& group, Reading& reading) {
  group.check_keys({"groom"},
                   {"model", "material", "clamped", "start", "root_velocity", "moves_with", "synthesis"});
  const JsonValue groom = group["groom"];
  const bool dense = group.has("synthesis");
  const ModelRow& model = *read_model(group);
  StrandSpec spec;
  spec.fibre = read_fibre(group);
  spec.start = read_held(group);
  spec.clamped = boolean_or(group, "clamped", true);
  spec.root_velocity = read_root_velocity(group);
  Rider* const rider = reading.rider(group);

  Strands strands = groom.has("style") ? grown(groom, dense, reading) : of_file(groom, dense, reading);
  Description& hair = reading.scene.hair;
  GroupRoots& read = reading.groups.back();
  read.rider = rider;
  for (std::size_t i = 0; i < strands.points.size(); ++i) {
    if (rider) rider->strands.push_back(static_cast<int>(hair.strands.size() + hair.modelled.size()));
    try {
      set_points(std::move(strands.points[i]), spec);
      add_strand(model, spec, hair);
    } catch (const std::invalid_argument& error) {
      groom.fail(strands.names[i] + error.what());
    }
    const auto points = static_cast<int>(model.points(spec));
    if (dense && i > 0 && points != read.points)
      groom.fail(strands.names[i] + "has " + std::to_string(points) + " points, and the first strand " +
                 std::to_string(read.points) + "; guides have as many, so give \"points\"");
    read.points = points;
  }
  if (dense) read_synthesis(group, std::move(strands.scalp), reading);
}

}  // namespace hair::json
