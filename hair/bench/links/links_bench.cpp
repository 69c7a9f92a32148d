// STAFF ONLY. Accelerations of a chain of spherical joints, beside libraries of rigid bodies: CPU time for each joint, and
// what each library's accelerations leave of Newton's and Euler's laws. All start from the same moving chain, in double
// precision, by one thread, and are timed in turn. A library that is not installed is named and left out.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>

#include "hair/bench/links/chain_engine.h"
#include "solver/timing.h"

namespace {

using namespace hair_bench;

// Curved anyhow, each rod turned by up to half a radian from the one before, and turning at up to 3 rad/s.
RodsMotion moving(int rods) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&](double size) {
    return Vector3d(size * any(generator), size * any(generator), size * any(generator));
  };
  RodsMotion motion;
  Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
  for (int i = 0; i < rods; ++i) {
    const Vector3d turn = vector(0.3);
    axes = (axes * Eigen::AngleAxisd(turn.norm(), turn.normalized())).normalized();
    motion.axes.push_back(axes);
    motion.omega.push_back(vector(3));
  }
  return motion;
}

// Without any recursion over inertias: the forces that the rods need at their joints, less their weight, must have no torque
// about a joint. Over the sum of all torques that take part.
double residual(const Rods& rods, const RodsMotion& motion, const std::vector<Vector3d>& alpha) {
  std::vector<Vector3d> center, force, torque;
  Vector3d joint = Vector3d::Zero(),
           a = Vector3d(0, 0, 9.81);  // of the joint, as if weight were an acceleration
  double size = 0;
  for (int i = 0; i < rods.count; ++i) {
    const Vector3d half = motion.axes[i] * Vector3d(0, 0, -rods.length / 2), &w = motion.omega[i];
    const auto from = [&](const Vector3d& arm) {
      return Vector3d(alpha[i].cross(arm) + w.cross(w.cross(arm)));
    };
    center.push_back(joint + half);
    force.push_back(rods.mass * (a + from(half)));
    const Eigen::Matrix3d axes = motion.axes[i].toRotationMatrix(),
                          tensor = axes * rods.moments.asDiagonal() * axes.transpose();
    const Vector3d spin = tensor * w;
    torque.push_back(tensor * alpha[i] + w.cross(spin));
    a += from(2 * half);
    joint += 2 * half;
    size += force.back().norm() * center.back().norm() + torque.back().norm();
  }
  double squared = 0;
  Vector3d all = Vector3d::Zero(), about = Vector3d::Zero();  // of the rods from i on, about the origin
  for (int i = rods.count - 1; i >= 0; --i) {
    all += force[i];
    about += torque[i] + center[i].cross(force[i]);
    const Vector3d at = center[i] - motion.axes[i] * Vector3d(0, 0, -rods.length / 2);
    squared += (about - at.cross(all)).squaredNorm();
  }
  return std::sqrt(squared) / size;
}

}  // namespace

int main() {
  constexpr int kTurns = 31;
  const std::pair<const char*, std::function<std::unique_ptr<ChainEngine>(const Rods&)>> engines[] = {
      {"H7", links_chain},
      {"DART", dart_chain},
      {"Bullet", bullet_chain},
      {"Simbody", simbody_chain},
      {"MuJoCo", mujoco_chain}};
  std::printf(
      "CPU time of all accelerations, ns for each joint: the median of %d turns; the ratio to H7's; what is "
      "left of "
      "the laws of motion\n\n| joints | library | ns | beside H7 | left |\n|--:|---|--:|--:|--:|\n",
      kTurns);
  for (const int count : {10, 30, 100, 300}) {
    const Rods rods{count};
    const RodsMotion motion = moving(count);
    struct Timed {
      const char* name;
      std::unique_ptr<ChainEngine> engine;
      int repeats = 1;
      std::vector<double> times = {};
    };
    std::vector<Timed> all;
    for (const auto& [name, make] : engines) {
      std::unique_ptr<ChainEngine> engine = make(rods);
      if (!engine) {
        if (count == 10) std::printf("| | %s: not installed | | | |\n", name);
        continue;
      }
      engine->set(motion);
      engine->accelerate();
      const double start = timing::cpu_seconds();
      engine->accelerate();
      const double once = std::max(1e-7, timing::cpu_seconds() - start);
      all.push_back({name, std::move(engine), std::clamp(static_cast<int>(2e-3 / once), 1, 2000)});
    }
    for (int turn = 0; turn < kTurns; ++turn)
      for (Timed& one : all) {
        const double start = timing::cpu_seconds();
        for (int k = 0; k < one.repeats; ++k) one.engine->accelerate();
        one.times.push_back(1e9 * (timing::cpu_seconds() - start) / (one.repeats * count));
      }
    const double ours = timing::median(all.front().times);
    for (const Timed& one : all) {
      const std::vector<Vector3d> alpha = one.engine->angular_accelerations();
      const double time = timing::median(one.times);
      std::printf("| %d | %s | %.0f | %.1f | ", count, one.name, time, time / ours);
      if (alpha.empty())
        std::printf("- |\n");
      else
        std::printf("%.0e |\n", residual(rods, motion, alpha));
      std::fflush(stdout);
    }
  }
}
