#include "hair/bench/links/chain_engine.h"

#if __has_include(<simbody/Simbody.h>) && __cplusplus < 202002L
#include <simbody/Simbody.h>

namespace hair_bench {

namespace {

SimTK::Vec3 vec(const Vector3d& v) {
  return {v[0], v[1], v[2]};
}

SimTK::Rotation rotation(const Eigen::Quaterniond& q) {
  return SimTK::Rotation(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z()));
}

class SimbodyChain final : public ChainEngine {
 public:
  explicit SimbodyChain(const Rods& rods) : matter_(system_), forces_(system_) {
    const SimTK::Force::UniformGravity gravity(forces_, matter_, SimTK::Vec3(0, 0, -9.81));
    const SimTK::Vec3 center(0, 0, -rods.length / 2);
    const SimTK::Inertia moments(vec(rods.moments));
    const SimTK::Body::Rigid rod(
        SimTK::MassProperties(rods.mass, center, moments.shiftFromMassCenter(-center, rods.mass)));
    for (int i = 0; i < rods.count; ++i) {
      const SimTK::Transform at(SimTK::Vec3(0, 0, i > 0 ? -rods.length : 0));
      if (i == 0)
        joints_.push_back(SimTK::MobilizedBody::Ball(matter_.Ground(), at, rod, SimTK::Transform()));
      else
        joints_.push_back(SimTK::MobilizedBody::Ball(joints_.back(), at, rod, SimTK::Transform()));
    }
    state_ = system_.realizeTopology();
  }

  void set(const RodsMotion& motion) override {
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
    Vector3d omega = Vector3d::Zero();
    for (std::size_t i = 0; i < motion.axes.size(); ++i) {
      joints_[i].setQToFitRotation(state_, rotation(axes.conjugate() * motion.axes[i]));
      joints_[i].setUToFitAngularVelocity(state_, vec(axes.conjugate() * Vector3d(motion.omega[i] - omega)));
      axes = motion.axes[i];
      omega = motion.omega[i];
    }
  }

  void accelerate() override {
    state_.updQ();  // what was calculated is old
    system_.realize(state_, SimTK::Stage::Acceleration);
  }

  std::vector<Vector3d> angular_accelerations() const override {
    std::vector<Vector3d> all;
    for (const SimTK::MobilizedBody& joint : joints_) {
      const SimTK::Vec3 alpha = joint.getBodyAngularAcceleration(state_);
      all.emplace_back(alpha[0], alpha[1], alpha[2]);
    }
    return all;
  }

 private:
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  std::vector<SimTK::MobilizedBody::Ball> joints_;
  SimTK::State state_;
};

}  // namespace

std::unique_ptr<ChainEngine> simbody_chain(const Rods& rods) {
  return std::make_unique<SimbodyChain>(rods);
}

}  // namespace hair_bench
#else
namespace hair_bench {

std::unique_ptr<ChainEngine> simbody_chain(const Rods&) {
  return nullptr;
}

}  // namespace hair_bench
#endif
