#include "hair/head/grow_line.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace hair {

namespace {

constexpr double kRise = 0.5;         // the slope at which hair rises from the head
constexpr double kFarthestTie = 0.6;  // m: hair that has come so far counts as tied

double smooth_step(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// The radius of a strand's curls at this distance from its root: they begin within a turn.
double curl_radius(const HairStyle& style, const StrandTraits& traits, double s) {
  return style.radius > 0 ? style.radius * traits.size * smooth_step(s / style.pitch) : 0;
}

// The direction to which a strand turns. On an upward part of the head it follows the combed direction,
// because it rests there. On the face it does, too, because hair is kept off the face. Elsewhere it falls.
Vector3d way_down(const Head& head, const HairStyle& style, const Vector3d& x, const Surface& here, double s,
                  double clearance) {
  const double begun = std::exp(-(s / style.comb) * (s / style.comb));
  const double near = std::clamp(2 - here.distance / clearance, 0.0, 1.0);
  const double rests = near * std::max(here.normal.z(), near > 0 ? head.on_face(x) : 0.0);
  const double combed = std::max(begun, smooth_step(2 * rests));
  return combed * head.combed(x) - (1 - combed) * Vector3d::UnitZ();
}

// Moves a strand across to its clump's line, by the growth of its part in this step, and by at most half a
// step. A move along the line would only make steps shorter or longer.
Vector3d drawn_to(const Line& clump, std::size_t k, double gathered, const Vector3d& x, double step) {
  if (k >= clump.size()) return Vector3d::Zero();
  const double all = static_cast<double>(clump.size() - 1);
  const double before = gathered * smooth_step(static_cast<double>(k - 1) / all);
  const double now = gathered * smooth_step(static_cast<double>(k) / all);
  const Vector3d along = (clump[k] - clump[k - 1]).normalized(), gap = clump[k] - x;
  const Vector3d way = (now - before) / (1 - before) * (gap - gap.dot(along) * along);
  return way * std::min(1.0, 0.5 * step / std::max(way.norm(), 1e-12));
}

// Moves the piece between the point at x[k] and the next one. Returns true if it had to move.
bool move_piece_out_of(const Head& head, Eigen::VectorXd& x, Eigen::Index k) {
  constexpr int parts = 4;
  constexpr double smallest_radius = 0.04;  // m, of a head's surface
  const double part = (x.segment<3>(k + 3) - x.segment<3>(k)).norm() / parts;
  // A line of this height between two checked points does not enter a ball of this radius, not even from its
  // surface.
  const double kept = part * part / (2 * smallest_radius);
  bool moved = false;
  for (int i = 1; i <= parts; ++i) {
    const double t = static_cast<double>(i) / parts;
    const Vector3d point = (1 - t) * x.segment<3>(k) + t * x.segment<3>(k + 3);
    const Surface there = head.surface_at(point);
    if (there.distance >= kept) continue;
    const Vector3d out = (1.01 * (kept - there.distance) + 1e-7) * there.normal;
    // The root stays.
    if (k > 0) x.segment<3>(k) += out;
    x.segment<3>(k + 3) += k > 0 ? out : Vector3d(out / t);
    moved = true;
  }
  return moved;
}

}  // namespace

Line middle_line(const Head& head, const HairStyle& style, const RootFrame& root, const StrandTraits& traits,
                 const LineSettings& settings, const Line* clump) {
  const double turn = std::min(0.5, settings.step / style.stiffness);
  Vector3d tie = Vector3d::Zero();
  if (style.tie) {
    const Vector3d at = head.surface_towards(style.tie->normalized());
    tie = at + 0.025 * head.surface_at(at).normal + traits.tie_offset;
  }
  bool tied = !style.tie.has_value();
  Line line = {root.position};
  Vector3d direction = traits.direction;
  double s = 0, falls = 0;  // lengths: from the root, and the part that counts
  while (falls < traits.length) {
    const Vector3d& x = line.back();
    const Surface here = head.surface_at(x);
    const Vector3d to = tied ? way_down(head, style, x, here, s, settings.clearance) : (tie - x).normalized();
    direction += turn * (to - direction);
    // A strand on the head turns along its surface.
    if (here.distance < settings.clearance)
      direction -= std::min(0.0, direction.dot(here.normal)) * here.normal;
    if (direction.norm() < 1e-3) direction = head.combed(x);
    direction.normalize();
    Vector3d next = x + settings.step * direction;
    if (clump) next += drawn_to(*clump, line.size(), traits.gathered, next, settings.step);
    const double kept =
        std::min(settings.clearance, kRise * (s + settings.step)) + curl_radius(style, traits, s);
    if (const Surface there = head.surface_at(next); there.distance < kept)
      next += (kept - there.distance) * there.normal;
    // A line that is stuck between the head and its target ends, too.
    const double length = std::max((next - x).norm(), 0.1 * settings.step);
    s += length;
    if (tied) falls += length;
    tied = tied || (tie - next).norm() < 2 * settings.step || s > kFarthestTie;
    line.push_back(next);
  }
  // The last piece is cut at the wanted length.
  const Vector3d last = line.back() - line[line.size() - 2];
  line.back() -= std::min(1.0, (falls - traits.length) / last.norm()) * last;
  return line;
}

Line with_curls(const Line& middle, const HairStyle& style, const RootFrame& root,
                const StrandTraits& traits) {
  Line line = {root.position};
  Vector3d across = root.side;
  double s = 0;
  for (std::size_t k = 1; k < middle.size(); ++k) {
    s += (middle[k] - middle[k - 1]).norm();
    const Vector3d along = (middle[std::min(k + 1, middle.size() - 1)] - middle[k - 1]).normalized();
    // The frame follows the line without turning about it.
    across -= across.dot(along) * along;
    if (across.norm() < 1e-6) across = side_of(along);
    across.normalize();
    const double angle = traits.phase + 2 * std::numbers::pi * s / style.pitch;
    const Vector3d out = style.flat
                             ? Vector3d(std::sin(angle) * across)
                             : Vector3d(std::cos(angle) * across + std::sin(angle) * along.cross(across));
    line.push_back(middle[k] + curl_radius(style, traits, s) * out);
  }
  return line;
}

Line cut(Line line, double length) {
  double s = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Vector3d piece = line[k] - line[k - 1];
    if (s + piece.norm() >= length) {
      line[k] = line[k - 1] + (length - s) / piece.norm() * piece;
      line.resize(k + 1);
      return line;
    }
    s += piece.norm();
  }
  return line;
}

void move_out_of(const Head& head, Eigen::VectorXd& x) {
  constexpr int most_rounds = 50;
  bool moved = true;
  for (int round = 0; round < most_rounds && moved; ++round) {
    moved = false;
    for (Eigen::Index k = 0; k + 3 < x.size(); k += 3) moved = move_piece_out_of(head, x, k) || moved;
  }
}

}  // namespace hair
