// Contact of rods with obstacles, as forces at the middle and the outer end of each rod, for linearly implicit steps.
//
// A point that is inside an obstacle, or would be after the step, is pressed out. With the gap g to the surface (negative
// inside) and the normal n where the point is now, and u its velocity beside the obstacle's,
//
//   N = max(-k (g + h n . u), 0)                            the pressure at the end of the step, see kContactRate
//   friction = -mu N_before u_t / max(|u_t|, kCreep)        u_t the part of u along the surface, at the end of the step
//
// so that a point comes to rest on the surface within a step, without a bounce. Both join the link's inertia, h^2 k n n^T and
// h c (1 - n n^T) (hair/rigid_links/tree_system.h). A step is made again without the points that the surface would have
// to pull. The friction's size is that of the pressure one step before: a point sticks as long as that suffices, but
// for creep below kCreep.
//
// Between these points a rod can go into an obstacle, and an obstacle smaller than a step's way can be missed.
#pragma once

#include <span>
#include <vector>

#include "hair/rigid_links/tree_system.h"
#include "hair/strand/obstacles.h"

namespace hair {

inline constexpr double kContactRate = 1e4;  // 1/s: k is the rod's mass times the square of this
inline constexpr double kCreep = 1e-5;       // m/s
// m: what is deeper was brought there by a long step, not by weight. Friction leaves that part of the pressure out; otherwise
// it would hold the point inside.
inline constexpr double kRestingDepth = 2e-5;
inline constexpr double kPushOut = 0.3;  // m/s: what is deep inside comes out no faster

// A point of a rod, where it is and how it moves.
struct RodPoint {
  int link;
  double along;        // m, from the link's centre of mass outward
  double mass;         // kg, of the rod
  Vector3d x, v, arm;  // arm: from the centre of mass
};

class RodContacts {
 public:
  explicit RodContacts(int points) : pressed_(points), before_(points) {}

  // The start of a step: finds what will touch. points[i] is the same point in each step.
  void find(std::span<const RodPoint> points, const std::vector<Obstacle>& obstacles, const Vector3d& gravity,
            double h);

  // The forces of all points that touch.
  void add(std::span<const RodPoint> points, std::vector<LinkForce>& forces) const;

  // With the links' accelerations in the step: lets go of the points that would be pulled. False: there are none.
  bool let_go(std::span<const RodPoint> points, const std::vector<LinkPass>& links);

  int contacts() const { return contacts_; }  // points that touched, in the step before
  double deepest() const {
    return deepest_;
  }  // m, the largest depth at which a point was before it and after it

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
  double h_ = 0;
  int contacts_ = 0;
  double deepest_ = 0;
};

}  // namespace hair
