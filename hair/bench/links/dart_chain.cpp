#include "hair/bench/links/chain_engine.h"

#if __has_include(<dart/dynamics/Skeleton.hpp>)
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Skeleton.hpp>

namespace hair_bench {

namespace {

using dart::dynamics::BallJoint, dart::dynamics::BodyNode, dart::dynamics::Skeleton;

class DartChain final : public ChainEngine {
 public:
  explicit DartChain(const Rods& rods) : skeleton_(Skeleton::create()) {
    BodyNode* parent = nullptr;
    for (int i = 0; i < rods.count; ++i) {
      BallJoint::Properties joint;
      joint.mName = "joint " + std::to_string(i);
      if (i > 0) joint.mT_ParentBodyToJoint.translation() = Vector3d(0, 0, -rods.length / 2);
      joint.mT_ChildBodyToJoint.translation() = Vector3d(0, 0, rods.length / 2);
      BodyNode::AspectProperties body("rod " + std::to_string(i));
      const Eigen::Matrix3d moments = rods.moments.asDiagonal();
      body.mInertia = dart::dynamics::Inertia(rods.mass, Vector3d::Zero(), moments);
      parent = skeleton_->createJointAndBodyNodePair<BallJoint>(parent, joint, body).second;
    }
    skeleton_->setGravity(Vector3d(0, 0, -9.81));
  }

  void set(const RodsMotion& motion) override {
    positions_.resize(3 * static_cast<Eigen::Index>(motion.axes.size()));
    velocities_.resize(positions_.size());
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
    Vector3d omega = Vector3d::Zero();
    for (std::size_t i = 0; i < motion.axes.size(); ++i) {
      const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
      const Eigen::Quaterniond turn = axes.conjugate() * motion.axes[i];
      positions_.segment<3>(at) = BallJoint::convertToPositions(turn.toRotationMatrix());
      velocities_.segment<3>(at) = motion.axes[i].conjugate() * Vector3d(motion.omega[i] - omega);
      axes = motion.axes[i];
      omega = motion.omega[i];
    }
  }

  void accelerate() override {
    skeleton_->setPositions(positions_);
    skeleton_->setVelocities(velocities_);
    skeleton_->computeForwardDynamics();
  }

  std::vector<Vector3d> angular_accelerations() const override {
    std::vector<Vector3d> all;
    for (std::size_t i = 0; i < skeleton_->getNumBodyNodes(); ++i)
      all.push_back(skeleton_->getBodyNode(i)->getAngularAcceleration());
    return all;
  }

 private:
  dart::dynamics::SkeletonPtr skeleton_;
  Eigen::VectorXd positions_, velocities_;
};

}  // namespace

std::unique_ptr<ChainEngine> dart_chain(const Rods& rods) {
  return std::make_unique<DartChain>(rods);
}

}  // namespace hair_bench
#else
namespace hair_bench {

std::unique_ptr<ChainEngine> dart_chain(const Rods&) {
  return nullptr;
}

}  // namespace hair_bench
#endif
