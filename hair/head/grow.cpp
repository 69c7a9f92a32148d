#include "hair/head/grow.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "hair/groom/nearest_points.h"
#include "hair/groom/resample.h"
#include "hair/head/grow_line.h"
#include "hair/head/scalp_roots.h"
#include "hair/strand/variation.h"

namespace hair {

namespace {

// Each use of a seed has its own numbers, so that one use changes no other.
enum class Use : std::uint64_t { roots, clump_roots, strands, clumps };

std::uint64_t seed_of(std::uint64_t seed, Use use) {
  return 4 * seed + static_cast<std::uint64_t>(use);
}

struct Clumps {
  std::vector<Line> lines;
  std::vector<StrandTraits> traits;
  NearestPoints roots;
};

class Grower {
 public:
  Grower(const Head& head, const HairStyle& style, int points, std::uint64_t seed)
      : head_(head),
        scalp_(head),
        style_(style),
        points_(points),
        seed_(seed),
        clumps_{{}, {}, NearestPoints({})} {
    const double whole = style.length + (style.tie ? 0.2 : 0);
    step_ = std::min(0.004, whole / 48);
    if (style.radius > 0) step_ = std::min(step_, style.pitch / 16);
    // A chord inside a layer of this height stays outside a head of the radius 7 cm, wherever the hair
    // begins.
    const double chord = whole / (points - 1);
    clearance_ = std::clamp(0.6 * chord * chord / 0.07, 0.003, 0.02);
  }

  void grow_clumps(int strands) {
    if (style_.clump == 0) return;
    const int count = std::max(1, strands / style_.clump);
    std::vector<Vector3d> places;
    for (const RootFrame& root : scalp_.roots(count, seed_of(seed_, Use::clump_roots))) {
      Variation variation(seed_of(seed_, Use::clumps), places.size());
      const StrandTraits traits = traits_of(root, variation, false);
      clumps_.lines.push_back(middle(root, traits, clearance_ + layer_below(root), nullptr));
      clumps_.traits.push_back(traits);
      places.push_back(root.position);
    }
    clumps_.roots = NearestPoints(std::move(places));
  }

  std::vector<RootFrame> roots(int strands) const {
    return scalp_.roots(strands, seed_of(seed_, Use::roots));
  }

  Eigen::VectorXd strand(const RootFrame& root, std::size_t number) const {
    Variation variation(seed_of(seed_, Use::strands), number);
    const bool flies = variation.uniform(0, 1) < style_.fly_aways;
    StrandTraits traits = traits_of(root, variation, flies);
    const double clearance = clearance_ * variation.uniform(0.7, 1.5) + layer_below(root);
    const Line* clump = nullptr;
    if (!clumps_.lines.empty() && !flies) {
      const auto nearest = static_cast<std::size_t>(clumps_.roots.nearest(root.position).index);
      clump = &clumps_.lines[nearest];
      traits.gathered = style_.gathered * variation.uniform(0.8, 1);
      // Curls of a clump lie inside each other.
      traits.phase = clumps_.traits[nearest].phase + variation.uniform(-0.4, 0.4);
      traits.size = clumps_.traits[nearest].size;
      if (!style_.tie) traits.length = clumps_.traits[nearest].length;
    }
    Line line = middle(root, traits, clearance, clump);
    if (style_.radius > 0) {
      line = with_curls(line, style_, root, traits);
      if (!style_.tie) line = cut(std::move(line), traits.length);
    }
    const Eigen::Map<const Eigen::VectorXd> all(line.front().data(),
                                                3 * static_cast<Eigen::Index>(line.size()));
    Eigen::VectorXd x = resampled(all, points_);
    move_out_of(head_, x);
    return x;
  }

 private:
  StrandTraits traits_of(const RootFrame& root, Variation& variation, bool flies) const {
    StrandTraits traits;
    traits.length = style_.length * (1 + style_.varies * variation.uniform(-1, 1));
    const double lift = flies ? 0.5 * (1 + style_.lift) : style_.lift;
    Vector3d side = root.side;
    if (style_.tie) {
      const Vector3d to = head_.surface_towards(style_.tie->normalized()) - root.position;
      const Vector3d along = to - to.dot(root.axis) * root.axis;
      if (along.norm() > 1e-6) side = along.normalized();
    }
    const Vector3d way = (lift * root.axis + (1 - lift) * side).normalized();
    traits.direction =
        varied({root.position, way, side_of(way)}, flies ? 2 * style_.tilt : style_.tilt, 0, variation).axis;
    traits.phase = variation.uniform(0, 2 * std::numbers::pi);
    traits.size = variation.uniform(0.8, 1.2);
    // Spreads strands evenly over the tie's cross-section, as seen from behind.
    const double angle = variation.uniform(0, 2 * std::numbers::pi);
    const double far = 0.011 * std::sqrt(variation.uniform(0, 1));
    traits.tie_offset = far * Vector3d(std::cos(angle), 0, std::sin(angle));
    return traits;
  }

  // The thickness of the hair below a strand: hair covers the hair with lower roots, or nearer to the tie.
  double layer_below(const RootFrame& root) const {
    const Vector3d over = style_.tie ? -style_.tie->normalized() : Vector3d(Vector3d::UnitZ());
    return style_.layer * (0.5 + 0.5 * over.dot((root.position - head_.centre()).normalized()));
  }

  Line middle(const RootFrame& root, StrandTraits traits, double clearance, const Line* clump) const {
    if (style_.radius > 0 && !style_.flat && !style_.tie) {
      // The length is enough for the wanted curls, the first of which are smaller.
      const double turn = std::hypot(2 * std::numbers::pi * style_.radius * traits.size, style_.pitch);
      traits.length = std::min(traits.length, traits.length * style_.pitch / turn + style_.pitch);
    }
    return middle_line(head_, style_, root, traits, {step_, clearance}, clump);
  }

  const Head& head_;
  Scalp scalp_;
  const HairStyle& style_;
  int points_;
  std::uint64_t seed_;
  double step_ = 0, clearance_ = 0;
  Clumps clumps_;
};

void describe(GroomLook& look, const std::string& text) {
  look.thickness = 1e-4F;
  look.colour = {0.22F, 0.12F, 0.05F};
  std::copy_n(text.begin(), std::min(text.size(), look.info.size()), look.info.begin());
}

}  // namespace

Groom grow_groom(const Head& head, const HairStyle& style, const GrowSettings& settings) {
  const int points = settings.points > 0 ? settings.points : style.points;
  if (settings.strands < 1)
    throw std::invalid_argument("a groom of " + std::to_string(settings.strands) +
                                " strands; 1 or more are right");
  if (points < fewest_points(style))
    throw std::invalid_argument("strands of " + std::to_string(points) + " points; " + style.name + " has " +
                                std::to_string(fewest_points(style)) + " at least, to follow its shape");
  if (settings.strands > kMostGroomPoints / points)
    throw std::invalid_argument(std::to_string(settings.strands) + " strands of " + std::to_string(points) +
                                " points; a groom has at most " + std::to_string(kMostGroomPoints) +
                                " points in all");
  Grower grower(head, style, points, settings.seed);
  grower.grow_clumps(settings.strands);
  Groom groom;
  groom.strands.reserve(static_cast<std::size_t>(settings.strands));
  for (const RootFrame& root : grower.roots(settings.strands))
    groom.strands.push_back(grower.strand(root, groom.strands.size()));
  describe(groom.look,
           "hairlab groom " + std::string(style.name) + " --seed " + std::to_string(settings.seed));
  return groom;
}

}  // namespace hair
