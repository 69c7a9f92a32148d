// A chain of rods with spherical joints in a library of rigid bodies, to be timed beside H7's passes.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace hair_bench {

using Eigen::Vector3d;

// n equal rods, the first one held at the origin. A rod's centre of mass is length / 2 from its joint, along -z of its axes.
struct Rods {
  int count;
  double length = 1, mass = 1;                            // m, kg
  Vector3d moments = Vector3d(1 / 12.0, 1 / 12.0, 0.02);  // kg m^2, about the centre of mass
};

// Of each rod, beside the world.
struct RodsMotion {
  std::vector<Eigen::Quaterniond> axes;
  std::vector<Vector3d> omega;  // rad/s
};

class ChainEngine {
 public:
  ChainEngine() = default;
  ChainEngine(const ChainEngine&) = delete;
  ChainEngine& operator=(const ChainEngine&) = delete;
  virtual ~ChainEngine() = default;

  virtual void set(const RodsMotion& motion) = 0;

  // One calculation of all accelerations of the motion that was set, from places on; under gravity, 9.81 m/s^2 along -z.
  virtual void accelerate() = 0;

  // The rods' angular accelerations, rad/s^2, along the world's axes. Empty if the library does not tell.
  virtual std::vector<Vector3d> angular_accelerations() const = 0;
};

// Null where the library is not installed, or can't hold so many rods.
std::unique_ptr<ChainEngine> links_chain(const Rods& rods);  // H7
std::unique_ptr<ChainEngine> bullet_chain(
    const Rods& rods);                                      // libbullet-dev, btMultiBody in double precision
std::unique_ptr<ChainEngine> dart_chain(const Rods& rods);  // libdart-dev
std::unique_ptr<ChainEngine> mujoco_chain(const Rods& rods);   // libmujoco-dev
std::unique_ptr<ChainEngine> simbody_chain(const Rods& rods);  // libsimbody-dev

}  // namespace hair_bench
