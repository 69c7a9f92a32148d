#include "hair/bench/links/chain_engine.h"

#if HAIR_HAS_BULLET_DOUBLE
#include <BulletDynamics/Featherstone/btMultiBody.h>

namespace hair_bench {

namespace {

// Bullet's own convention of a spherical joint's rate is not documented: it is timed, and tells no accelerations.
class BulletChain final : public ChainEngine {
 public:
  explicit BulletChain(const Rods& rods)
      : body_(rods.count, 0, btVector3(0, 0, 0), true, false), weight_(0, 0, -9.81 * rods.mass) {
    const btVector3 half(0, 0, -rods.length / 2), moments(rods.moments[0], rods.moments[1], rods.moments[2]);
    for (int i = 0; i < rods.count; ++i)
      body_.setupSpherical(i, rods.mass, moments, i - 1, btQuaternion::getIdentity(),
                           i > 0 ? half : btVector3(0, 0, 0), half);
    body_.finalizeMultiDof();
    body_.setLinearDamping(0);
    body_.setAngularDamping(0);
    body_.setUseGyroTerm(true);
    body_.setCanSleep(false);
  }

  void set(const RodsMotion& motion) override {
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
    Vector3d omega = Vector3d::Zero();
    turns_.clear();
    rates_.clear();
    for (std::size_t i = 0; i < motion.axes.size(); ++i) {
      const Eigen::Quaterniond turn = axes.conjugate() * motion.axes[i];
      turns_.emplace_back(turn.x(), turn.y(), turn.z(), turn.w());
      const Vector3d rate = motion.axes[i].conjugate() * Vector3d(motion.omega[i] - omega);
      rates_.emplace_back(rate[0], rate[1], rate[2]);
      axes = motion.axes[i];
      omega = motion.omega[i];
    }
  }

  void accelerate() override {
    body_.clearForcesAndTorques();
    for (int i = 0; i < body_.getNumLinks(); ++i) {
      btScalar turn[4] = {turns_[i].x(), turns_[i].y(), turns_[i].z(), turns_[i].w()};
      body_.setJointPosMultiDof(i, turn);
      btScalar rate[3] = {rates_[i].x(), rates_[i].y(), rates_[i].z()};
      body_.setJointVelMultiDof(i, rate);
      body_.addLinkForce(i, weight_);
    }
    body_.computeAccelerationsArticulatedBodyAlgorithmMultiDof(btScalar(1e-3), numbers_, vectors_, matrices_,
                                                               false, false, false);
  }

  std::vector<Vector3d> angular_accelerations() const override { return {}; }

 private:
  btMultiBody body_;
  btVector3 weight_;
  std::vector<btQuaternion> turns_;
  std::vector<btVector3> rates_;
  btAlignedObjectArray<btScalar> numbers_;
  btAlignedObjectArray<btVector3> vectors_;
  btAlignedObjectArray<btMatrix3x3> matrices_;
};

}  // namespace

std::unique_ptr<ChainEngine> bullet_chain(const Rods& rods) {
  return std::make_unique<BulletChain>(rods);
}

}  // namespace hair_bench
#else
namespace hair_bench {

std::unique_ptr<ChainEngine> bullet_chain(const Rods&) {
  return nullptr;
}

}  // namespace hair_bench
#endif
