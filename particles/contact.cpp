#include "particles/contact.h"

#include <cmath>

#include "particles/require.h"

namespace particles {
namespace {

void require_penalty(double stiffness, double damping) {
  require(stiffness >= 0, "contact: stiffness", stiffness, ">= 0");
  require(damping >= 0, "contact: damping", damping, ">= 0");
}

struct Surface {
  Vector3d normal;
  double distance;  // of the particle from the sphere's centre
  double depth;     // below the surface
};

Surface below(const Vector3d& centre, double radius, const Vector3d& x) {
  const Vector3d d = x - centre;
  const double distance = d.norm();
  return {distance > 0 ? Vector3d(d / distance) : Vector3d(0, 0, 1), distance, radius - distance};
}

}  // namespace

PlaneContact::PlaneContact(const Vector3d& point, const Vector3d& normal, double stiffness, double damping)
    : point_(point), normal_(normal / normal.norm()), stiffness_(stiffness), damping_(damping) {
  require(normal.norm() > 0 && std::isfinite(normal.norm()), "PlaneContact: length of the normal",
          normal.norm(), "> 0 and finite");
  require_penalty(stiffness, damping);
}

double PlaneContact::energy(Input x) const {
  double energy = 0;
  for (int k = 0; k < x.size(); k += 3) {
    const double depth = normal_.dot(point_ - x.segment<3>(k));
    if (depth > 0) energy += 0.5 * stiffness_ * depth * depth;
  }
  return energy;
}

void PlaneContact::add_force(Input x, Input v, Output f) const {
  for (int k = 0; k < x.size(); k += 3) {
    const double depth = normal_.dot(point_ - x.segment<3>(k));
    const double push = stiffness_ * depth - damping_ * normal_.dot(v.segment<3>(k));
    if (depth > 0 && push > 0) f.segment<3>(k) += push * normal_;
  }
}

void PlaneContact::add_dfdx(Input x, Input v, Input dx, Output df) const {
  for (int k = 0; k < x.size(); k += 3) {
    const double depth = normal_.dot(point_ - x.segment<3>(k));
    const double push = stiffness_ * depth - damping_ * normal_.dot(v.segment<3>(k));
    if (depth > 0 && push > 0) df.segment<3>(k) -= stiffness_ * normal_.dot(dx.segment<3>(k)) * normal_;
  }
}

void PlaneContact::add_dfdv(Input x, Input v, Input dv, Output df) const {
  for (int k = 0; k < x.size(); k += 3) {
    const double depth = normal_.dot(point_ - x.segment<3>(k));
    const double push = stiffness_ * depth - damping_ * normal_.dot(v.segment<3>(k));
    if (depth > 0 && push > 0) df.segment<3>(k) -= damping_ * normal_.dot(dv.segment<3>(k)) * normal_;
  }
}

SphereContact::SphereContact(const Vector3d& centre, double radius, double stiffness, double damping,
                             Products products)
    : centre_(centre), radius_(radius), stiffness_(stiffness), damping_(damping), products_(products) {
  require(radius > 0, "SphereContact: radius", radius, "> 0");
  require_penalty(stiffness, damping);
}

double SphereContact::energy(Input x) const {
  double energy = 0;
  for (int k = 0; k < x.size(); k += 3) {
    const double depth = radius_ - (x.segment<3>(k) - centre_).norm();
    if (depth > 0) energy += 0.5 * stiffness_ * depth * depth;
  }
  return energy;
}

void SphereContact::add_force(Input x, Input v, Output f) const {
  for (int k = 0; k < x.size(); k += 3) {
    const Surface surface = below(centre_, radius_, x.segment<3>(k));
    const double push = stiffness_ * surface.depth - damping_ * surface.normal.dot(v.segment<3>(k));
    if (surface.depth > 0 && push > 0) f.segment<3>(k) += push * surface.normal;
  }
}

void SphereContact::add_dfdx(Input x, Input v, Input dx, Output df) const {
  for (int k = 0; k < x.size(); k += 3) {
    const Surface surface = below(centre_, radius_, x.segment<3>(k));
    const double push = stiffness_ * surface.depth - damping_ * surface.normal.dot(v.segment<3>(k));
    if (!(surface.depth > 0 && push > 0)) continue;
    const Vector3d change = dx.segment<3>(k);
    const double along = change.dot(surface.normal);
    df.segment<3>(k) -= stiffness_ * along * surface.normal;
    if (products_ == Products::definite || surface.distance == 0) continue;
    const Vector3d turn = (change - along * surface.normal) / surface.distance;  // of the normal
    df.segment<3>(k) += push * turn - damping_ * turn.dot(v.segment<3>(k)) * surface.normal;
  }
}

void SphereContact::add_dfdv(Input x, Input v, Input dv, Output df) const {
  for (int k = 0; k < x.size(); k += 3) {
    const Surface surface = below(centre_, radius_, x.segment<3>(k));
    const double push = stiffness_ * surface.depth - damping_ * surface.normal.dot(v.segment<3>(k));
    if (surface.depth > 0 && push > 0)
      df.segment<3>(k) -= damping_ * surface.normal.dot(dv.segment<3>(k)) * surface.normal;
  }
}

}  // namespace particles
