// The interface of everything that moves in a scene: a strand of masses and springs, of rigid links, of
// helices; a toy. Every strand model derives its body from it. Code that runs, measures, draws or compares
// scenes uses only this interface.
//
// A body has its own coordinates q (positions, joint angles, curvatures) with their rates. Its centre line, a
// list of points in space, follows from them. Files and messages hold states as coordinates, because a centre
// line does not contain the twist.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hair/obstacles/obstacles.h"
#include "hair/strand/blow_up.h"
#include "hair/strand/watch.h"
#include "particles/vectors.h"

namespace hair {

// The motion of a root during a step. tangent and normal have length 1 and are perpendicular; a hinge ignores
// them.
struct Root {
  Vector3d position;          // m, at the end of the next step
  Vector3d tangent, normal;   // also at the end of the step
  Vector3d velocity;          // m/s, during the step
  Vector3d angular_velocity;  // rad/s
};

// A force at a point of the centre line, with its derivative: f - stiffness dx. The stiffness is symmetric
// and positive semi-definite, so that implicit steps may add it to their matrix.
struct PointForce {
  int point;
  Vector3d force;             // N
  Eigen::Matrix3d stiffness;  // N/m
};

// The parameters of a step.
struct BodyStep {
  double h;          // s
  double tolerance;  // relative, for implicit solves
  const std::vector<Obstacle>& obstacles;
  std::span<const PointForce> forces = {};  // during the whole step; not for bodies without point forces
};

// The effort of steps. Each step adds its numbers.
struct Work {
  long strand_steps = 0;      // steps times strands
  long solver_steps = 0;      // iterations of ConjGrad
  long plain_solves = 0;      // solves that had no preconditioner
  long correction_steps = 0;  // Newton steps of the length correction
  long solves = 0;            // solves and corrections
  long unconverged = 0;       // those that ended above their tolerance
  long unmended = 0;          // collisions after which obstacles and lengths did not agree (H6)
  long kept_steps = 0;        // steps of rigid links with momenta of the step before
  long contacts = 0;          // particles that were pushed out of an obstacle
  double penetration = 0;     // m, the largest depth of a particle that remained in an obstacle

  Work& operator+=(const Work& other) {
    strand_steps += other.strand_steps;
    solver_steps += other.solver_steps;
    plain_solves += other.plain_solves;
    correction_steps += other.correction_steps;
    solves += other.solves;
    unconverged += other.unconverged;
    unmended += other.unmended;
    kept_steps += other.kept_steps;
    contacts += other.contacts;
    penetration = std::max(penetration, other.penetration);
    return *this;
  }
};

struct BodyMeasures {
  double stretch = 0;                            // the largest |l - l0| / l0 of all parts with a rest length
  double kinetic = 0, potential = 0;             // J
  Vector3d momentum = Vector3d::Zero();          // kg m/s
  Vector3d angular_momentum = Vector3d::Zero();  // kg m^2/s, about the origin
  std::optional<Vector3d> tip = {};              // m; none: the body has no tip

  double energy() const { return kinetic + potential; }
};

// The meaning of q for masses and springs, and for toys, in files and replies: positions of the centre line's
// points, m. Other models have numbers of their own (ModelRow::coordinates).
inline constexpr std::uint32_t kPositions = 0, kOfSeveralModels = 3;

class Body {
 public:
  Body() = default;
  virtual ~Body() = default;
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  virtual int size() const = 0;    // the numbers in q, and in its rate: a multiple of 3
  virtual int points() const = 0;  // the points of the centre line

  // The arc lengths of these points at rest, from the root, m: with them lines with different numbers of
  // points are compared (hair/strand/measures.h). Empty: the points lie on no line.
  virtual Eigen::VectorXd arc_lengths() const = 0;

  // The memory that a step needs: bodies share one matrix of at least `scratch_rows` x `scratch_columns`.
  virtual int scratch_rows() const = 0;
  virtual int scratch_columns() const = 0;

  // q and rate: size() numbers each.
  virtual void read(particles::Output q, particles::Output rate) const = 0;
  virtual void write(particles::Input q, particles::Input rate) = 0;

  // Takes effect with the next step. A body without a root ignores it.
  virtual void set_root(const Root& root) = 0;
  virtual Vector3d root_position() const = 0;  // m, now

  // One step, including collisions. Adds to `work`; allocates nothing, apart from ConjGrad's own memory. If
  // the body breaks, returns the stage, and leaves numbers that may be infinite or NaN.
  virtual std::optional<Stage> step(const BodyStep& step, const particles::Scratch& scratch, Work& work) = 0;

  // Sizes of the last step, for the simulation's watch.
  virtual Sizes sizes() const { return {}; }

  // For any coordinates of this body, also of a state from elsewhere. x, v: 3 points() numbers each.
  virtual void centre_line(particles::Input q, particles::Input rate, particles::Output x,
                           particles::Output v) const = 0;
  virtual BodyMeasures measure(particles::Input q, particles::Input rate) const = 0;
};

}  // namespace hair
