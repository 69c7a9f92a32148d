#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hair/groom/farthest_points.h"
#include "hair/groom/resample.h"
#include "hair/head/grow.h"
#include "hair/head/scalp_roots.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

constexpr double kMostPicked = 5000;

// Strands of a file.
struct FileText {
  std::optional<JsonValue> file;
  double scale;
  std::optional<int> strands, points;
  Vector3d move = Vector3d::Zero();
};

void keys_of(Keys& keys, FileText& groom) {
  keys.about(
      "Reads `.hair` files (www.cemyuksel.com/research/hairmodels) and `.ply` files with strands. Bald "
      "roots, which are strands of a single point, are left out; `hairlab run --explain` says how many. "
      "`hairlab info` shows what is in a file "
      "([lab/README.md](../lab/README.md#hairlab-info-convert-groom)).");
  keys.any("file", groom.file, {.needed = true}, "its path counts from the scene's folder");
  keys.number("scale", groom.scale, {.unit = "m", .needed = true, .least = 1e-6, .most = 1e6},
              "what the file's unit is");
  keys.whole("strands", groom.strands, {.least = 1, .most = kMostPicked, .otherwise = "all of them"},
             "takes so many, well spread over the scalp; what bends too much for hair is left out then");
  keys.whole("points", groom.points, {.least = 2, .most = kMostPoints, .otherwise = "the file's"},
             "of each strand, at equal distances along it");
  keys.vector("move", groom.move, {.unit = "m"}, "moves the groom, once it has its scale");
}

// A group that has "groom".
struct GroomedText {
  std::optional<JsonValue> groom;
  GroupText group;
};

void keys_of(Keys& keys, GroomedText& text) {
  keys.about(
      "Strands from a file, or strands that grow on a head, in the shape that they have there. Clamped "
      "strands have this shape as their rest shape. Masses and springs that are not clamped have its "
      "lengths, and are straight at rest; rigid links keep the shape.");
  keys.any("groom", text.groom,
           {.needed = true, .objects = {object<FileText>(), {grown_section, " that grows"}}});
  keys_of(keys, text.group);
}

// The strands of a groom, in metres, and the scalp on which they grow.
struct Strands {
  std::vector<Eigen::VectorXd> points;
  std::vector<std::string> names;  // one for each strand, for errors
  GroupScalp scalp;                // if the group has dense hair
};

// The first point that coincides with the previous one; 0 if there is none.
Eigen::Index first_without_length(const Eigen::VectorXd& x) {
  for (Eigen::Index k = 3; k < x.size(); k += 3)
    if (x.segment<3>(k) == x.segment<3>(k - 3)) return k / 3;
  return 0;
}

// True if all joints bend by less than kMostRest, so that none loses its frame.
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
  const auto [file, scale, picked, points, move] = read<FileText>(groom);
  if (!reading.groom) groom["file"].fail("this scene can't have files of its own; leave the groom out");
  const std::vector<Eigen::VectorXd> all = reading.groom(groom["file"]);
  std::vector<std::size_t> hairs;  // in the file
  std::vector<RootFrame> roots;
  std::vector<Vector3d> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].size() == 3) {
      ++reading.scene.bald_roots;
      continue;
    }
    hairs.push_back(i);
    roots.push_back(root_of(all[i]));
    roots.back().position = scale * roots.back().position + move;
    places.push_back(roots.back().position);
  }
  if (hairs.empty()) groom["file"].fail("all its strands are bald roots, of a single point");

  Strands found;
  if (dense) found.scalp = scalp_of(roots);
  std::vector<RootFrame> guides;
  for (const std::size_t k :
       farthest_points(places, picked ? static_cast<std::size_t>(*picked) : hairs.size())) {
    const Eigen::VectorXd& whole = all[hairs[k]];
    reading.expect(groom, 1, points ? *points : whole.size() / 3);
    Eigen::VectorXd x = points ? resampled(whole, *points) : whole;
    // The scene's choice depends on no particular strand: it skips those that can't be hair.
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

// Strands that grow on a head.
Strands grown(const JsonValue& groom, bool dense, Reading& reading) {
  auto [head, at, style, settings, motion] = read_grown(groom);
  // Guides are in no clump: the dense hair around them forms wisps.
  if (dense) style.clump = 0, style.fly_aways = 0;
  reading.expect(groom["strands"], settings.strands, settings.points ? settings.points : style.points);
  settings.strands = reading.made(settings.strands);
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

const Section& groomed_section() {
  return section_of<GroomedText>();
}

void add_groomed(const JsonValue& object, Reading& reading) {
  const GroomedText text = read<GroomedText>(object);
  const JsonValue& groom = *text.groom;
  const bool dense = text.group.synthesis.has_value();
  const ModelRow& model = models()[text.group.model];
  StrandSpec spec = spec_of(object, text.group);
  Rider* const rider = reading.rider(object, text.group.moves_with);

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
  if (dense) add_synthesis(object["synthesis"], *text.group.synthesis, std::move(strands.scalp), reading);
}

}  // namespace hair::json
