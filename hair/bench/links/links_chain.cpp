#include "hair/bench/links/chain_engine.h"
#include "hair/rigid_links/tree_system.h"

namespace hair_bench {

namespace {

hair::LinkTree tree_of(const Rods& rods) {
  std::vector<hair::LinkShape> shapes(rods.count);
  for (int i = 0; i < rods.count; ++i) {
    hair::LinkShape& shape = shapes[i];
    shape.parent = i;
    shape.joint = hair::JointType::spherical;
    if (i > 0) shape.joint_at = Vector3d(0, 0, -rods.length / 2);
    shape.center = Vector3d(0, 0, -rods.length / 2);
    shape.mass = rods.mass;
    shape.moments = rods.moments;
  }
  return hair::LinkTree(shapes);
}

class LinksChain final : public ChainEngine {
 public:
  explicit LinksChain(const Rods& rods) : system_(tree_of(rods), {.gravity = Vector3d(0, 0, -9.81)}) {
    q_.resize(system_.tree().coordinates());
    rates_.resize(system_.tree().rates());
    accelerations_.resize(system_.tree().rates());
  }

  void set(const RodsMotion& motion) override {
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
    Vector3d omega = Vector3d::Zero();
    for (std::size_t i = 0; i < motion.axes.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      q_.segment<4>(4 * at) = (axes.conjugate() * motion.axes[i]).coeffs();
      rates_.segment<3>(3 * at) = motion.omega[i] - omega;
      axes = motion.axes[i];
      omega = motion.omega[i];
    }
  }

  void accelerate() override { system_.accelerations({}, q_, rates_, 0, {}, accelerations_); }

  std::vector<Vector3d> angular_accelerations() const override {
    std::vector<Vector3d> all;
    for (std::size_t i = 1; i < system_.motion().passes.size(); ++i)
      all.push_back(system_.motion().passes[i].a.angular);
    return all;
  }

 private:
  hair::TreeSystem system_;
  Eigen::VectorXd q_, rates_, accelerations_;
};

}  // namespace

std::unique_ptr<ChainEngine> links_chain(const Rods& rods) {
  return std::make_unique<LinksChain>(rods);
}

}  // namespace hair_bench
