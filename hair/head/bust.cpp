#include "hair/head/bust.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "hair/head/bust_parts.h"

namespace hair {

namespace {

// Hair grows above this line, as seen from the side: forehead, temple, sideburn, ear, and nape.
double hairline(double y) {
  struct Corner {
    double y, z;
  };
  constexpr std::array<Corner, 10> line = {{{-0.090, 0.062},
                                            {-0.072, 0.056},
                                            {-0.056, 0.034},
                                            {-0.036, 0.022},
                                            {-0.026, -0.012},
                                            {-0.012, -0.012},
                                            {-0.006, 0.022},
                                            {0.034, 0.020},
                                            {0.046, -0.020},
                                            {0.070, -0.072}}};
  if (y <= line.front().y) return line.front().z;
  for (std::size_t i = 1; i < line.size(); ++i)
    if (y <= line[i].y)
      return std::lerp(line[i - 1].z, line[i].z, (y - line[i - 1].y) / (line[i].y - line[i - 1].y));
  return line.back().z;
}

// 1 for the front of the head, down to below the chin.
double face_of(const Vector3d& point, const Vector3d& normal) {
  constexpr double chin = -0.13;  // m
  const auto smooth_step = [](double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
  };
  return smooth_step((-normal.y() - 0.2) / 0.4) * smooth_step((point.z() - chin) / 0.03) *
         smooth_step((-0.02 - point.y()) / 0.03);
}

}  // namespace

Bust::Value Bust::value_at(const Vector3d& point) const {
  return value_of_parts(point, LeaveOut::what_is_far);
}

Surface Bust::surface_at(const Vector3d& point) const {
  constexpr double least_slope = 0.3;  // deep inside, the slope may vanish
  constexpr double far = 0.05;         // m: the distance from the box replaces the value then
  const Vector3d out = point - point.cwiseMax(box().min()).cwiseMin(box().max());
  if (const double distance = out.norm(); distance > far) return {distance, out / distance};
  const auto [value, gradient] = value_at(point);
  const double slope = gradient.norm();
  return {value / std::max(slope, least_slope),
          slope > 0 ? Vector3d(gradient / slope) : Vector3d(Vector3d::UnitZ())};
}

Eigen::AlignedBox3d Bust::box() const {
  return {Vector3d(-0.21, -0.12, -0.36), Vector3d(0.21, 0.13, 0.12)};
}

Vector3d Bust::surface_towards(const Vector3d& direction) const {
  constexpr double shortest = 1e-3;  // m
  double inside = 0, outside = 0;
  while (true) {
    const double value = value_at(centre() + outside * direction).value;
    if (value >= 0) break;
    inside = outside;
    outside += std::max(shortest, -0.7 * value);
  }
  // Steps of Newton's method, which never leave the interval that contains the surface.
  constexpr double rounding = 1e-15;  // relative to s; smaller steps would alternate
  double s = outside;
  for (int i = 0; i < 60; ++i) {
    const Value here = value_at(centre() + s * direction);
    (here.value >= 0 ? outside : inside) = s;
    const double next = s - here.value / here.gradient.dot(direction);
    if (std::abs(next - s) <= rounding * s) break;
    s = next > inside && next < outside ? next : 0.5 * (inside + outside);
  }
  return centre() + s * direction;
}

double Bust::on_face(const Vector3d& point) const {
  return face_of(point, surface_at(point).normal);
}

bool Bust::has_hair(const Vector3d& point) const {
  return point.z() >= hairline(point.y());
}

Vector3d Bust::combed(const Vector3d& point) const {
  constexpr double far = 0.045;  // m: at this distance from the parting, hair falls
  const Vector3d parting(kPartingSide, std::clamp(point.y(), kPartingFront, kPartingBack), 0);
  Vector3d away(point.x() - parting.x(), point.y() - parting.y(), 0);
  const double distance = away.norm();
  away = distance > 0 ? Vector3d(away / distance) : Vector3d(Vector3d::UnitX());
  const double begun = 1 / (1 + std::pow(distance / far, 4));
  const Vector3d normal = surface_at(point).normal;
  const Vector3d aside(std::copysign(1.0, point.x() - kPartingSide), 0.5, 0);
  const Vector3d way = begun * (away + 0.35 * Vector3d::UnitY()) - 0.8 * Vector3d::UnitZ() +
                       2 * face_of(point, normal) * aside;
  const Vector3d along = way - normal.dot(way) * normal;
  // Hair is never combed straight out.
  return along.norm() > 1e-6 ? along.normalized() : normal.unitOrthogonal();
}

}  // namespace hair
