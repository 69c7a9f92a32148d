#include "hair/head/scalp_roots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "hair/strand/variation.h"

namespace hair {

namespace {

constexpr double kJitter = 0.2;  // times the usual distance between roots
constexpr int kBands = 64, kCells = 128;

Vector3d direction_at(double height, double turn) {
  const double across = std::sqrt(std::max(0.0, 1 - height * height));
  return {across * std::cos(turn), across * std::sin(turn), height};
}

// The areas of a head's surface, by the direction from its centre: the sphere of directions is divided into
// bands of equal height, and these into cells of equal width. All cells have the same solid angle
// (Archimedes).
class SurfaceAreas {
 public:
  explicit SurfaceAreas(const Head& head) {
    constexpr double solid_angle = 4 * std::numbers::pi / (kBands * kCells);
    for (std::size_t band = 0; band < kBands; ++band) {
      std::array<double, kCells + 1>& along = along_[band];
      for (std::size_t cell = 0; cell < kCells; ++cell) {
        const Vector3d way = direction_at(-1 + 2 * (static_cast<double>(band) + 0.5) / kBands,
                                          2 * std::numbers::pi * (static_cast<double>(cell) + 0.5) / kCells);
        const Vector3d point = head.surface_towards(way);
        // The surface is farther away than a unit sphere, and not perpendicular to the ray. Away from the
        // scalp a ray may touch it, and no area is needed there.
        const double area = solid_angle * (point - head.centre()).squaredNorm() /
                            std::max(0.1, head.surface_at(point).normal.dot(way));
        along[cell + 1] = along[cell] + area;
        if (!head.has_hair(point)) continue;
        scalp_ += area;
        add_near(band, cell);
      }
      until_[band + 1] = until_[band] + along.back();
      for (double& area : along) area /= along_[band].back() > 0 ? along.back() : 1;
    }
  }

  // True if there is hair in the cell of a direction or next to it: this is faster than finding the head's
  // surface.
  bool may_have_hair(const Vector3d& direction) const {
    const double turn = std::atan2(direction.y(), direction.x()) / (2 * std::numbers::pi);
    const auto band =
        static_cast<std::size_t>(std::clamp((direction.z() + 1) / 2 * kBands, 0.0, kBands - 1.0));
    const auto cell =
        static_cast<std::size_t>(std::clamp((turn - std::floor(turn)) * kCells, 0.0, kCells - 1.0));
    return near_scalp_[band][cell];
  }

  double whole() const { return until_.back(); }
  double scalp() const { return scalp_; }

  // The direction with the part u of the area below it, and the part v of its band's area before it.
  Vector3d direction(double u, double v) const {
    const double band = place(until_, u * until_.back());
    // Interpolates between the middles of two bands, so that neighbours stay neighbours.
    const double lower = std::clamp(std::floor(band - 0.5), 0.0, kBands - 1.0);
    const double upper = std::min(lower + 1, kBands - 1.0);
    const double part = std::clamp(band - 0.5 - lower, 0.0, 1.0);
    const double cell = (1 - part) * place(along_[static_cast<std::size_t>(lower)], v) +
                        part * place(along_[static_cast<std::size_t>(upper)], v);
    return direction_at(-1 + 2 * band / kBands, 2 * std::numbers::pi * cell / kCells);
  }

 private:
  void add_near(std::size_t band, std::size_t cell) {
    for (std::size_t b = band == 0 ? 0 : band - 1; b <= std::min<std::size_t>(band + 1, kBands - 1); ++b)
      for (const std::size_t c : {cell + kCells - 1, cell, cell + 1}) near_scalp_[b][c % kCells] = true;
  }

  // The place of this value among ascending numbers, as an index with a fraction.
  template <std::size_t n>
  static double place(const std::array<double, n>& rising, double value) {
    const auto after = std::upper_bound(rising.begin() + 1, rising.end() - 1, value);
    const double from = *(after - 1), to = *after;
    return static_cast<double>(after - 1 - rising.begin()) +
           (to > from ? std::clamp((value - from) / (to - from), 0.0, 1.0) : 0);
  }

  std::array<double, kBands + 1> until_{};
  std::array<std::array<double, kCells + 1>, kBands> along_{};
  std::array<std::array<bool, kCells>, kBands> near_scalp_{};
  double scalp_ = 0;
};

// The points on the scalp among `tried` points of the lattice.
std::vector<Vector3d> points_of_lattice(const Head& head, const SurfaceAreas& areas, double tried,
                                        double spacing, std::uint64_t seed) {
  const double start = Variation(seed).uniform(0, 1);
  std::vector<Vector3d> points;
  for (double i = 0; i < tried; ++i) {
    const double turns = start + i * (std::numbers::phi - 1);
    const Vector3d way = areas.direction((i + 0.5) / tried, turns - std::floor(turns));
    if (!areas.may_have_hair(way)) continue;
    const Vector3d even = head.surface_towards(way);
    Variation own(seed, static_cast<std::uint64_t>(i));
    const double angle = own.uniform(0, 2 * std::numbers::pi);
    const double far = kJitter * spacing * std::sqrt(own.uniform(0, 1));
    const Vector3d normal = head.surface_at(even).normal, x = side_of(normal), y = normal.cross(x);
    const Vector3d moved = even + far * (std::cos(angle) * x + std::sin(angle) * y);
    const Vector3d point = head.surface_towards((moved - head.centre()).normalized());
    if (head.has_hair(point)) points.push_back(point);
  }
  return points;
}

}  // namespace

class Scalp::Areas : public SurfaceAreas {
  using SurfaceAreas::SurfaceAreas;
};

Scalp::Scalp(const Head& head) : head_(head), areas_(std::make_shared<Areas>(head)) {}

double Scalp::area() const {
  return areas_->scalp();
}

std::vector<RootFrame> Scalp::roots(int count, std::uint64_t seed) const {
  if (count < 0)
    throw std::invalid_argument("a scalp has " + std::to_string(count) + " roots; 0 or more are right");
  if (count == 0) return {};
  const SurfaceAreas& areas = *areas_;
  if (!(areas.scalp() > 0))
    throw std::invalid_argument("a head has no scalp; give it a place where hair grows");
  const double spacing = std::sqrt(areas.scalp() / count);
  // Tries a few more than expected, and repeats if necessary, because the table has only a rough edge of the
  // scalp.
  double tried = std::ceil(1.01 * count * areas.whole() / areas.scalp()) + 5;
  std::vector<Vector3d> points = points_of_lattice(head_, areas, tried, spacing, seed);
  while (points.size() < static_cast<std::size_t>(count))
    points = points_of_lattice(head_, areas, tried = std::ceil(1.05 * tried), spacing, seed);
  std::vector<RootFrame> roots;
  roots.reserve(static_cast<std::size_t>(count));
  // Surplus points are removed evenly.
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto kept = static_cast<std::size_t>(count);
    if ((i + 1) * kept / points.size() == i * kept / points.size()) continue;
    roots.push_back({points[i], head_.surface_at(points[i]).normal, head_.combed(points[i])});
  }
  return roots;
}

}  // namespace hair
