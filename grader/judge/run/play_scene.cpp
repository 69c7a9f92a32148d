// STAFF ONLY. Runs a scene and keeps its frames, and computes the dense strands that it draws.
#include "grader/judge/run/play_scene.h"

#include <numeric>

#include "hair/scene/scene_run.h"

namespace grader::inline judge {
namespace {

Eigen::Index numbers_of(const hair::Synthesis& group) {
  return 3 * Eigen::Index{group.points()} * group.children();
}

}  // namespace

DenseStrands::DenseStrands(const hair::Scene& scene, const std::vector<int>& strands) : scene_(scene) {
  for (const hair::DenseHair& dense : scene.dense) {
    first_.push_back(3 * std::accumulate(strands.begin(), strands.begin() + dense.first, Eigen::Index{0}));
    groups_.push_back(std::make_unique<hair::Synthesis>(dense.description));
  }
}

std::vector<int> DenseStrands::sizes() const {
  std::vector<int> sizes;
  for (const auto& group : groups_)
    sizes.insert(sizes.end(), static_cast<std::size_t>(group->children()), group->points());
  return sizes;
}

Eigen::VectorXd DenseStrands::at(const Eigen::VectorXd& x, double time) {
  Eigen::Index size = 0, to = 0;
  for (const auto& group : groups_) size += numbers_of(*group);
  Eigen::VectorXd points(size);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const hair::DenseHair& dense = scene_.dense[g];
    const hair::ScalpTurn turn =
        dense.motion ? hair::ScalpTurn(way_at(*dense.motion, time).rotation.toRotationMatrix())
                     : hair::ScalpTurn(hair::ScalpTurn::Identity());
    const std::size_t guides = 3 * dense.description.guides.size() * groups_[g]->points();
    const Eigen::Index count = numbers_of(*groups_[g]);
    groups_[g]->make({x.data() + first_[g], guides}, turn, {},
                     std::span<double>(points.data() + to, static_cast<std::size_t>(count)));
    to += count;
  }
  return points;
}

void play_scene(const hair::Scene& scene, Played& played) {
  hair::Scene unwatched = scene;  // students need not have written energies
  unwatched.hair.watched = false;
  hair::SceneRun scene_run(unwatched);
  DenseStrands dense(scene, scene_run.strands());
  played.coordinates = scene_run.coordinates();
  const auto keep = [&] {
    played.frames.push_back(scene_run.state());
    if (!scene.dense.empty())
      played.dense.push_back(dense.at(scene_run.centre_lines(played.frames.back()).x, scene_run.time()));
  };
  keep();
  for (int k = 0; k < scene.frames && played.trouble.empty(); ++k) {
    played.trouble = scene_run.advance().value_or("");
    if (played.trouble.empty()) keep();
  }
  const hair::Work work = scene_run.work();
  played.solver_steps = work.solver_steps;
  played.correction_steps = work.correction_steps;
}

}  // namespace grader::judge
