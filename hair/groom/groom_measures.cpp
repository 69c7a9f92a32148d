#include "hair/groom/groom_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "hair/mass_spring/rest_curvature.h"

namespace hair {

namespace {

using Eigen::Vector3d;

constexpr double kScalp = 0.2;        // m
constexpr std::size_t kFewRoots = 3;  // so few roots do not show a scalp

class Count {
 public:
  void add(std::size_t strand) {
    if (count_++ == 0) first_ = strand;
  }
  void say(const std::string& one, const std::string& many, std::vector<Oddity>& odd) const {
    if (count_ > 0) odd.push_back({count_ == 1 ? one : many, count_, first_});
  }

 private:
  long count_ = 0;
  std::size_t first_ = 0;
};

// Numbers of all strands, and their positions.
struct Gathered {
  std::vector<double> points, lengths, segments, curvatures, bends;
  Count bald, not_finite, without_length, points_at_one_place, sharp;
};

void gather(const Eigen::VectorXd& x, std::size_t i, Gathered& all) {
  double length = 0;
  Vector3d before = Vector3d::Zero();  // the previous segment
  for (Eigen::Index k = 3; k < x.size(); k += 3) {
    const Vector3d segment = x.segment<3>(k) - x.segment<3>(k - 3);
    const double l = segment.norm();
    length += l;
    all.segments.push_back(l);
    if (l == 0) all.points_at_one_place.add(i);
    if (l > 0 && before.norm() > 0) {
      const Vector3d u = before.normalized(), v = segment.normalized();
      const double angle = std::atan2(u.cross(v).norm(), u.dot(v)), across = (before + segment).norm();
      all.bends.push_back(angle * 180 / std::numbers::pi);
      if (angle > kMostRest) all.sharp.add(i);
      if (across > 0) all.curvatures.push_back(2 * std::sin(angle) / across);
    }
    before = segment;
  }
  all.points.push_back(static_cast<double>(points_of(x)));
  all.lengths.push_back(length);
  if (length == 0) all.without_length.add(i);
}

}  // namespace

Spread spread_of(std::vector<double> numbers) {
  if (numbers.empty()) return {};
  const auto number_at = [&](double part) {
    const auto rank = static_cast<std::ptrdiff_t>(part * static_cast<double>(numbers.size() - 1));
    std::nth_element(numbers.begin(), numbers.begin() + rank, numbers.end());
    return numbers[static_cast<std::size_t>(rank)];
  };
  const double mean =
      std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
  return {number_at(0), number_at(0.5), mean, number_at(0.9), number_at(1)};
}

GroomMeasures measure_groom(const Groom& groom) {
  GroomMeasures measures;
  measures.strands = static_cast<long>(groom.strands.size());
  measures.points = points_of(groom);
  Gathered all;
  std::vector<Vector3d> roots;
  for (std::size_t i = 0; i < groom.strands.size(); ++i) {
    const Eigen::VectorXd& x = groom.strands[i];
    if (!x.allFinite()) {
      all.not_finite.add(i);
      continue;
    }
    for (Eigen::Index k = 0; k < x.size(); k += 3) measures.box.extend(x.segment<3>(k));
    measures.roots.extend(x.head<3>());
    roots.emplace_back(x.head<3>());
    if (points_of(x) < 2)
      all.bald.add(i);
    else
      gather(x, i, all);
  }
  if (roots.empty()) measures.box = measures.roots = Eigen::AlignedBox3d(Vector3d::Zero());
  measures.points_of_strand = spread_of(all.points);
  measures.length = spread_of(all.lengths);
  measures.segment = spread_of(all.segments);
  measures.curvature = spread_of(std::move(all.curvatures));
  measures.bend = spread_of(std::move(all.bends));

  all.not_finite.say("strand with a number that is not finite; no program can use it",
                     "strands with a number that is not finite; no program can use them", measures.odd);
  all.bald.say("bald root: a strand of a single point", "bald roots: strands of a single point",
               measures.odd);
  all.without_length.say("strand without length", "strands without length", measures.odd);
  all.points_at_one_place.say("point where the point before is; scenes refuse it",
                              "points where the point before is; scenes refuse them", measures.odd);
  all.sharp.say("joint that bends by more than 154 degrees; scenes refuse it",
                "joints that bend by more than 154 degrees; scenes refuse them", measures.odd);
  const double span = measures.roots.sizes().maxCoeff();
  if (roots.size() > kFewRoots && span > 0) measures.unit_guess = kScalp / span;
  measures.root_sphere = sphere_through(roots);
  return measures;
}

}  // namespace hair
