// What moves in a scene, whatever it is made of: a strand of masses and springs, of rigid links, of helices; a toy. Every
// strand model derives its body from this, and who plays, measures, draws or compares knows no more of it.
//
// A body has coordinates q of its own (positions, joint angles, curvatures) with their rates, and a centre line of points
// in space, which follow from them. States that are written, sent and read hold coordinates, for a centre line does not
// know its twist.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hair/strand/blow_up.h"
#include "hair/strand/obstacles.h"
#include "hair/strand/work.h"
#include "particles/vectors.h"

namespace hair {

// Where a root goes. tangent and normal have length 1 and are perpendicular; of a root that is a hinge they don't matter.
struct Root {
  Vector3d position;          // m, at the end of the next step
  Vector3d tangent, normal;   // then, too
  Vector3d velocity;          // m/s, on the way there
  Vector3d angular_velocity;  // rad/s
};

// A force at a point of the centre line, as it is now, with how it changes: f - stiffness dx. The stiffness is symmetric
// and semi-definite, so that implicit steps may add it to their matrix.
struct PointForce {
  int point;
  Vector3d force;             // N
  Eigen::Matrix3d stiffness;  // N/m
};

// What a step is told.
struct BodyStep {
  double h;          // s
  double tolerance;  // of implicit solves, relative
  const std::vector<Obstacle>& obstacles;
  std::span<const PointForce> forces = {};  // for the whole step; not for bodies that have no place for them
};

struct BodyMeasures {
  double stretch = 0;                            // the largest |l - l0| / l0 of what keeps its length
  double kinetic = 0, potential = 0;             // J
  Vector3d momentum = Vector3d::Zero();          // kg m/s
  Vector3d angular_momentum = Vector3d::Zero();  // kg m^2/s, about the origin
  std::optional<Vector3d> tip = {};              // m; none: it has no end

  double energy() const { return kinetic + potential; }
};

// What the numbers of q are, in files and replies, too: a reader refuses a number that it does not know.
enum class Coordinates : std::uint32_t { positions = 0 };

const char* coordinates_name(Coordinates coordinates);

class Body {
 public:
  Body() = default;
  virtual ~Body() = default;
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  virtual Coordinates coordinates() const = 0;
  virtual int size() const = 0;    // of q, and of its rate
  virtual int points() const = 0;  // of the centre line

  // What a step needs beside itself: bodies take turns with the same memory of `scratch_rows` x `scratch_columns` at least.
  virtual int scratch_rows() const = 0;
  virtual int scratch_columns() const = 0;

  // q and rate: size() numbers each.
  virtual void read(particles::Output q, particles::Output rate) const = 0;
  virtual void write(particles::Input q, particles::Input rate) = 0;

  // From the next step on. What has no root stays as it is.
  virtual void set_root(const Root& root) = 0;
  virtual Vector3d root_position() const = 0;  // m, now

  // One step, collisions included. Adds to `work`, allocates nothing beyond what ConjGrad does. Of a body that breaks it
  // says in which stage, and leaves numbers that may be infinite or NaN.
  virtual std::optional<Stage> step(const BodyStep& step, const particles::Scratch& scratch, Work& work) = 0;

  // Of any coordinates of this body: those of a state that came from elsewhere, too. x, v: 3 points() numbers each.
  virtual void centre_line(particles::Input q, particles::Input rate, particles::Output x,
                           particles::Output v) const = 0;
  virtual BodyMeasures measure(particles::Input q, particles::Input rate) const = 0;
};

}  // namespace hair
