#include "hair/super_helix/helix_motion.h"

#include <algorithm>
#include <cmath>

namespace hair {

namespace {

constexpr double kWidestPanel = 2;  // rad
constexpr int kNodes = 8;

struct GaussNode {
  double at, weight;  // on -1 to 1; the other half of the nodes is at -at
};
constexpr GaussNode kGauss[kNodes / 2] = {{0.1834346424956498, 0.3626837833783620},
                                          {0.5255324099163290, 0.3137066458778873},
                                          {0.7966664774136267, 0.2223810344533745},
                                          {0.9602898564975363, 0.1012285362903763}};

constexpr double kMostPanels =
    500;  // 160 turns: a strand with more has blown up, and must not take all memory

int panels(double angle) {
  return static_cast<int>(std::ceil(std::clamp(angle >= 0 ? angle / kWidestPanel : 1, 1.0, kMostPanels)));
}

// The motion of a point of an element relative to the element's start, which is held, along the start's axes.
struct Relative {
  Vector3d acceleration;       // m/s^2, of the point while q" = 0
  Vector3d spin_acceleration;  // rad/s^2, of the frame
};

// The second derivatives of (2) by time, p' = s (kappa1', kappa2', tau'), p" = 0. For a frame with the
// angular velocity V p', V = 1 + c_2 [p] + c_3 [p]^2, the result is V' p'.
Relative relative_acceleration(const Vector3d& curvature, const Vector3d& rate, double s) {
  const Vector3d p = s * curvature, v = s * rate, e(0, 0, 1);
  const double x = p.squaredNorm(), dx = 2 * p.dot(v), ddx = 2 * v.squaredNorm();
  const std::array<double, 8> c = stumpff(x);
  const auto derivative = [&](int k) { return (k * c[k + 2] - c[k + 1]) / 2; };
  const auto second_derivative = [&](int k) { return (k * derivative(k + 2) - derivative(k + 1)) / 2; };
  const double d2 = derivative(2) * dx, dd2 = second_derivative(2) * dx * dx + derivative(2) * ddx;
  const double d3 = derivative(3) * dx, dd3 = second_derivative(3) * dx * dx + derivative(3) * ddx;

  const Vector3d pe = p.cross(e), ve = v.cross(e), pv = p.cross(v);
  Relative result;
  result.acceleration = dd2 * pe + 2 * d2 * ve + dd3 * p.cross(pe) + 2 * d3 * (v.cross(pe) + p.cross(ve)) +
                        2 * c[3] * v.cross(ve);
  result.acceleration *= s;
  result.spin_acceleration = d2 * pv + d3 * p.cross(pv) + c[3] * v.cross(pv);
  return result;
}

}  // namespace

HelixMotion::HelixMotion(HelixStrand strand, std::vector<double> places)
    : elements(strand.elements()), placed(places.size()), strand_(std::move(strand)) {
  std::size_t most = places.size();
  for (int i = 0; i < strand_.elements(); ++i) {
    elements[i].length = strand_.lengths[i];
    most += kNodes * (1 + panels(strand_.lengths[i] * strand_.natural.segment<3>(3 * i).norm()));
  }
  points.reserve(most);
  weights.reserve(most);
  velocities.reserve(most);
  accelerations.reserve(most);

  for (std::size_t k = 0; k < places.size(); ++k) {
    int element = 0;
    double s = places[k];
    for (; element < strand_.elements() - 1 && s > strand_.lengths[element]; ++element)
      s -= strand_.lengths[element];
    places_.push_back({element, s, k});
  }
  std::stable_sort(places_.begin(), places_.end(),
                   [](const Place& a, const Place& b) { return a.element < b.element; });
}

void HelixMotion::place(const MaterialFrame& root, Input q) {
  for (std::size_t i = 0; i < elements.size(); ++i) elements[i].curvature = q.segment<3>(3 * i);
  carry_frames(root, elements);
  points.clear();
  weights.clear();
  auto place = places_.begin();
  for (int i = 0; i < strand_.elements(); ++i) {
    HelixElement& element = elements[i];
    element.at_end = jacobian_at(element.start, element.curvature, element.length);
    add_nodes(i);
    for (; place != places_.end() && place->element == i; ++place) {
      placed[place->number] = points.size();
      add_point(i, place->s, 0);
    }
  }
  velocities.resize(points.size());
  accelerations.resize(points.size());
}

void HelixMotion::add_nodes(int element) {
  const HelixElement& helix = elements[element];
  const int count = panels(helix.length * helix.curvature.norm());
  const double half = helix.length / count / 2;
  for (int panel = 0; panel < count; ++panel) {
    const double middle = (2 * panel + 1) * half;
    for (int k = kNodes / 2 - 1; k >= 0; --k)
      add_point(element, middle - kGauss[k].at * half, kGauss[k].weight * half);
    for (const GaussNode& node : kGauss) add_point(element, middle + node.at * half, node.weight * half);
  }
}

void HelixMotion::add_point(int element, double s, double weight) {
  const HelixElement& helix = elements[element];
  HelixPoint point;
  point.element = element;
  point.s = s;
  point.position = frame_at(helix.start, helix.curvature, s).position;
  point.moves = jacobian_at(helix.start, helix.curvature, s).moves;
  point.inertia.diagonal().setConstant(strand_.line_density * weight);
  points.push_back(point);
  weights.push_back(weight);
}

// An element's start moves a point like a rigid body; the element adds a velocity of its own.
void HelixMotion::move(const HelixRoot& root, Input rates) {
  Vector3d velocity = root.velocity, spin = root.spin;
  std::size_t j = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const HelixElement& helix = elements[i];
    const Vector3d &start = helix.start.position, rate = rates.segment<3>(3 * i);
    for (; j < points.size() && points[j].element == static_cast<int>(i); ++j)
      velocities[j] = velocity + spin.cross(points[j].position - start) + points[j].moves * rate;
    velocity += spin.cross(helix.end.position - start) + helix.at_end.moves * rate;
    spin += helix.at_end.turns * rate;
  }
}

// The derivative of the same, with Coriolis' term twice.
void HelixMotion::accelerate(const HelixRoot& root, Input rates) {
  Vector3d spin = root.spin, acceleration = root.acceleration, spin_acceleration = root.spin_acceleration;
  std::size_t j = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const HelixElement& helix = elements[i];
    const Matrix3d& axes = helix.start.axes;
    const Vector3d rate = rates.segment<3>(3 * i);
    const auto acceleration_at = [&](const Vector3d& position, const Vector3d& own,
                                     const Relative& relative) -> Vector3d {
      const Vector3d arm = position - helix.start.position;
      return acceleration + spin_acceleration.cross(arm) + spin.cross(spin.cross(arm) + 2 * own) +
             axes * relative.acceleration;
    };
    for (; j < points.size() && points[j].element == static_cast<int>(i); ++j)
      accelerations[j] = acceleration_at(points[j].position, points[j].moves * rate,
                                         relative_acceleration(helix.curvature, rate, points[j].s));
    const Relative relative = relative_acceleration(helix.curvature, rate, helix.length);
    const Vector3d turn = helix.at_end.turns * rate;
    acceleration = acceleration_at(helix.end.position, helix.at_end.moves * rate, relative);
    spin_acceleration += spin.cross(turn) + axes * relative.spin_acceleration;
    spin += turn;
  }
}

}  // namespace hair
