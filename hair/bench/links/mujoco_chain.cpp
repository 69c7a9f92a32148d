#include "hair/bench/links/chain_engine.h"

#if __has_include(<mujoco/mujoco.h>)
#include <mujoco/mujoco.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hair_bench {

namespace {

// MuJoCo reads models from files.
mjModel* model_of(const Rods& rods) {
  std::ostringstream text;
  text.precision(17);
  text << "<mujoco><compiler inertiafromgeom=\"false\" boundmass=\"0\" boundinertia=\"0\"/>"
          "<option gravity=\"0 0 -9.81\"><flag contact=\"disable\" "
          "constraint=\"disable\"/></option><worldbody>";
  for (int i = 0; i < rods.count; ++i)
    text << "<body pos=\"0 0 " << (i > 0 ? -rods.length : 0) << "\"><inertial pos=\"0 0 " << -rods.length / 2
         << "\" mass=\"" << rods.mass << "\" diaginertia=\"" << rods.moments.transpose()
         << "\"/><joint type=\"ball\"/>";
  for (int i = 0; i < rods.count; ++i) text << "</body>";
  text << "</worldbody></mujoco>";
  const auto file =
      std::filesystem::temp_directory_path() / ("hair-bench-rods-" + std::to_string(rods.count) + ".xml");
  std::ofstream(file) << text.str();
  char error[500] = "";
  mjModel* model = mj_loadXML(file.c_str(), nullptr, error, sizeof error);
  std::filesystem::remove(file);
  if (!model) throw std::runtime_error(std::string("MuJoCo: ") + error);
  return model;
}

class MujocoChain final : public ChainEngine {
 public:
  explicit MujocoChain(const Rods& rods) : model_(model_of(rods)), data_(mj_makeData(model_)) {}
  ~MujocoChain() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }

  void set(const RodsMotion& motion) override {
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
    Vector3d omega = Vector3d::Zero();
    for (std::size_t i = 0; i < motion.axes.size(); ++i) {
      const Eigen::Quaterniond turn = axes.conjugate() * motion.axes[i];
      mjtNum* q = data_->qpos + 4 * i;
      q[0] = turn.w(), q[1] = turn.x(), q[2] = turn.y(), q[3] = turn.z();
      const Vector3d rate = motion.axes[i].conjugate() * Vector3d(motion.omega[i] - omega);
      for (int k = 0; k < 3; ++k) data_->qvel[3 * i + k] = rate[k];
      axes = motion.axes[i];
      omega = motion.omega[i];
    }
  }

  void accelerate() override { mj_forward(model_, data_); }

  std::vector<Vector3d> angular_accelerations() const override {
    mj_rnePostConstraint(model_, data_);
    std::vector<Vector3d> all;
    for (int body = 1; body < model_->nbody; ++body)
      all.emplace_back(data_->cacc[6 * body], data_->cacc[6 * body + 1], data_->cacc[6 * body + 2]);
    return all;
  }

 private:
  mjModel* model_;
  mjData* data_;
};

}  // namespace

std::unique_ptr<ChainEngine> mujoco_chain(const Rods& rods) {
  constexpr int kDeepest = 60;  // its reader of XML goes no deeper than 100 elements
  return rods.count <= kDeepest ? std::make_unique<MujocoChain>(rods) : nullptr;
}

}  // namespace hair_bench
#else
namespace hair_bench {

std::unique_ptr<ChainEngine> mujoco_chain(const Rods&) {
  return nullptr;
}

}  // namespace hair_bench
#endif
