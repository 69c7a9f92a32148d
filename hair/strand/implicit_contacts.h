// Contact of a strand's points with obstacles, as forces for linearly implicit steps.
//
// A point that is inside an obstacle, or would be after the step, is pressed out. With the gap g to the
// surface (negative inside) and the normal n where the point is now, and u its velocity beside the
// obstacle's,
//
//   N = max(-k (g + h n . u), 0)                            the pressure at the end of the step, see kContactRate
//   friction = -mu N_before u_t / max(|u_t|, kCreep)        u_t the part of u along the surface, at the end of the step
//
// so that a point comes to rest on the surface within a step, without a bounce. Both grow with the point's
// velocity: they add h^2 k n n^T and h c (1 - n n^T) to what resists its acceleration. A step is made again
// without the points that the surface would have to pull. The friction's size is that of the pressure one
// step before: a point sticks as long as that suffices, but for creep below kCreep.
//
// Between these points a strand can go into an obstacle, and an obstacle smaller than a step's way can be
// missed.
#pragma once

#include <span>
#include <vector>

#include "hair/strand/energy_watch.h"
#include "hair/strand/obstacles.h"

namespace hair {

inline constexpr double kContactRate = 1e4;  // 1/s: k is the point's mass times the square of this
inline constexpr double kCreep = 1e-5;       // m/s
// m: what is deeper was brought there by a long step, not by weight. Friction leaves that part of the
// pressure out; otherwise it would hold the point inside.
inline constexpr double kRestingDepth = 2e-5;
inline constexpr double kPushOut = 0.3;  // m/s: what is deep inside comes out no faster

// Times that a step is made again with fewer contacts, at most.
inline constexpr int kMostContactSteps = 10;

// A point of a strand, where it is and how it moves.
struct ContactPoint {
  double mass = 0;  // kg, of the piece of hair that it stands for
  Vector3d x = Vector3d::Zero(), v = Vector3d::Zero();
};

// A force on a point, f - S dx - C dv with dx and dv the changes in the step.
struct ContactForce {
  std::size_t point;
  Vector3d force;                      // N
  Eigen::Matrix3d stiffness, damping;  // N/m, N s/m
};

class ImplicitContacts {
 public:
  explicit ImplicitContacts(std::size_t points) : pressed_(points), before_(points) {
    forces_.reserve(points);
  }

  // The start of a step: finds what will touch. points[i] is the same point in each step.
  void find(std::span<const ContactPoint> points, const std::vector<Obstacle>& obstacles,
            const Vector3d& gravity, double h);

  // Of all points that touch.
  std::span<const ContactForce> forces(std::span<const ContactPoint> points);

  // With the points' velocities after the step, as the step has them: lets go of the points that would be
  // pulled. False: there are none.
  bool let_go(std::span<const Vector3d> velocities);

  // What the obstacles did in the step, with these velocities at its end.
  ContactWork work(std::span<const Vector3d> velocities) const;

  int contacts() const { return contacts_; }  // points that touched, in the step before
  // m, the largest depth at which a point was before it and after it
  double deepest() const { return deepest_; }

 private:
  struct Pressed {
    const Obstacle* by = nullptr;  // none: it does not touch
    Vector3d normal = Vector3d::Zero(), velocity = Vector3d::Zero();
    double k = 0, gap = 0;  // the gap that it is pressed by: kPushOut
    double depth = 0;       // m, > 0 inside
    double friction = 0;    // N s/m
    double pressure = 0;    // N, of the step
  };

  std::vector<Pressed> pressed_, before_;
  std::vector<ContactForce> forces_;
  double h_ = 0;
  int contacts_ = 0;
  double deepest_ = 0;
};

}  // namespace hair
