// Contact of a strand's points with obstacles, as forces for linearly implicit steps.
//
// A point that is inside an obstacle, or would be after the step, is pressed out. With g the gap to the
// surface (negative inside), n the normal at the point's present position, and u its velocity relative to the
// obstacle,
//
//   N = max(-k (g + h n . u), 0)                        the pressure at the step's end, see kContactRate
//   friction = -mu N_before u_t / max(|u_t|, kCreep)    u_t: u along the surface, at the step's end
//
// so that a point comes to rest on the surface within a step, without a bounce. Both forces grow with the
// point's velocity: they add h^2 k n n^T and h c (1 - n n^T) to its inertia. A step is repeated without the
// points that the surface would have to pull. The friction's size follows from the pressure of the previous
// step: a point sticks as long as that is enough, except for creep below kCreep.
//
// Between these points a strand can enter an obstacle, and a point can miss an obstacle that is smaller than
// its displacement in a step.
#pragma once

#include <span>
#include <vector>

#include "hair/obstacles/obstacles.h"
#include "hair/strand/energy_watch.h"

namespace hair {

inline constexpr double kContactRate = 1e4;  // 1/s: k is the point's mass times the square of this
inline constexpr double kCreep = 1e-5;       // m/s
// m: a deeper point was brought there by a long step, not by weight. Friction ignores the pressure of the
// additional depth, which would hold the point inside.
inline constexpr double kRestingDepth = 2e-5;
inline constexpr double kPushOut = 0.3;  // m/s: the largest speed at which a point deep inside comes out

// The largest number of times that a step is repeated with fewer contacts.
inline constexpr int kMostContactSteps = 10;

// A point of a strand: its position and its motion.
struct ContactPoint {
  double mass = 0;  // kg, of the point's piece of hair
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

  // Starts a step: finds the points that will touch. points[i] is the same point in each step.
  void find(std::span<const ContactPoint> points, const std::vector<Obstacle>& obstacles,
            const Vector3d& gravity, double h);

  // The forces on all points that touch.
  std::span<const ContactForce> forces(std::span<const ContactPoint> points);

  // Takes the points' velocities after the step, and releases the points that would be pulled. Returns false
  // if there are none.
  bool let_go(std::span<const Vector3d> velocities);

  // The work of the obstacles in the step, with these velocities at its end.
  ContactWork work(std::span<const Vector3d> velocities) const;

  int contacts() const { return contacts_; }  // points that touched in the last step
  // m, the largest depth of a point before or after the step
  double deepest() const { return deepest_; }

 private:
  struct Pressed {
    const Obstacle* by = nullptr;  // none: it does not touch
    Vector3d normal = Vector3d::Zero(), velocity = Vector3d::Zero();
    double k = 0, gap = 0;  // the gap that gives its pressure: see kPushOut
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
