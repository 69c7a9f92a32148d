#include "hair/lab/head/head_hair.h"

#include "hair/groom/farthest_points.h"
#include "hair/head/grow.h"

namespace hair::head_study {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kStraightPoints = 25;
// Curls are shorter than the styles that have names, so that fewer points follow the hair: m.
constexpr double kStraightLength = 0.36, kWavyLength = 0.2, kCurlyLength = 0.1;

HairStyle styled(const char* name, double length = 0) {
  HairStyle style = *find_hair_style(name);
  if (length > 0) style.length = length;
  return style;
}

HairStyle without_chance(HairStyle style) {
  style.varies = style.tilt = style.fly_aways = 0;
  style.clump = 0;
  return style;
}

HeadHair curved(const char* id, const char* title, const HairStyle& style) {
  return {id, title, style, fewest_points(style), true};
}

}  // namespace

const std::vector<HeadHair>& head_hairs() {
  static const std::vector<HeadHair> all = {
      {"straight", "Straight hair", styled("long-smooth", kStraightLength), kStraightPoints, false},
      {"combed", "Straight hair, all alike", without_chance(styled("long-smooth", kStraightLength)),
       kStraightPoints, false},
      curved("wavy", "Wavy hair", styled("wavy", kWavyLength)),
      curved("curly", "Curly hair", styled("short-curly", kCurlyLength))};
  return all;
}

GrownHead grow_head(const Bust& bust, const HeadHair& hair, int strands) {
  GrownHead head{&hair, {}, grow_groom(bust, hair.style, {strands, hair.points, kSeed}).strands, 0};
  head.roots.reserve(head.strands.size());
  for (const Eigen::VectorXd& x : head.strands) {
    const Vector3d normal = bust.surface_at(x.head<3>()).normal;
    head.roots.push_back({x.head<3>(), normal, side_of(normal)});
    for (Eigen::Index k = 3; k < x.size(); k += 3)
      head.length += (x.segment<3>(k) - x.segment<3>(k - 3)).norm();
  }
  head.length /= static_cast<double>(head.strands.size());
  return head;
}

std::vector<std::size_t> choose_guides(const GrownHead& head, int guides) {
  std::vector<Vector3d> places;
  places.reserve(head.roots.size());
  for (const RootFrame& root : head.roots) places.push_back(root.position);
  return farthest_points(places, static_cast<std::size_t>(guides));
}

}  // namespace hair::head_study
