#include "hair/scene/scene_run.h"

#include <algorithm>
#include <string>

#include "hair/simulation/models.h"
#include "particles/require.h"

namespace hair {

namespace {

void add(FrameMeasures& sum, const BodyMeasures& part) {
  if (!(part.stretch <= sum.stretch)) sum.stretch = part.stretch;  // true also for NaN
  sum.kinetic += part.kinetic;
  sum.potential += part.potential;
  sum.momentum += part.momentum;
  sum.angular_momentum += part.angular_momentum;
}

void check_times(const Scene& scene) {
  particles::require_at_least("the steps of a frame", scene.steps_per_frame, 1);
  particles::require_positive("the frames of a second", scene.frames_per_second);
  particles::require_positive("the step", scene.hair.step);
}

std::string trouble(const char* what, int which, long step, Stage stage) {
  return std::string(what) + " " + std::to_string(which) + ", step " + std::to_string(step) + ": " +
         stage_name(stage);
}

}  // namespace

SceneRun::SceneRun(const Scene& scene)
    : h_(scene.hair.step),
      tolerance_(scene.hair.tolerance),
      steps_per_frame_(scene.steps_per_frame),
      frames_per_second_(scene.frames_per_second),
      watched_(scene.hair.watched),
      solver_(row_of(scene.hair.method).exercises.back()),
      toys_watch_(static_cast<int>(scene.toys.size())),
      still_(scene.hair.obstacles) {
  check_times(scene);
  if (has_strands(scene)) {
    simulation_.emplace(scene.hair);
    ride(scene);
    for (int i = 0; i < simulation_->strands(); ++i) strands_.push_back(simulation_->body(i).points());
  }
  for (const int points : strands_) mesh_size_ += 3 * points;
  add_toys(scene.toys);
  for (int i = 0; i < bodies(); ++i) size_ += body(i).size();
  coordinates_.assign(static_cast<std::size_t>(bodies()), kPositions);
  for (std::size_t i = 0; i < scene.hair.modelled.size(); ++i)
    coordinates_[scene.hair.strands.size() + i] = scene.hair.modelled[i].model->coordinates;
}

void SceneRun::restart(const Scene& scene) {
  check_times(scene);
  particles::require(scene.toys.size() == toys_.size(), "the toys of a scene that starts anew",
                     static_cast<double>(scene.toys.size()), std::to_string(toys_.size()));
  if (simulation_) {
    simulation_->restart(scene.hair);
    ride(scene);
  }
  scratch_.setZero();
  for (std::size_t i = 0; i < toys_.size(); ++i)
    toys_[i]->write(scene.toys[i].start.x, scene.toys[i].start.v);
  toys_work_ = {};
  toys_watch_ = Watch(static_cast<int>(toys_.size()));
  h_ = scene.hair.step;
  steps_per_frame_ = scene.steps_per_frame;
  frames_per_second_ = scene.frames_per_second;
  frame_ = 0;
  steps_ = 0;
  trouble_.reset();
}

void SceneRun::leave_out(std::span<const int> strands) {
  if (simulation_) simulation_->leave_out(strands);
}

std::optional<std::string> SceneRun::advance() {
  for (int k = 0; k < steps_per_frame_ && !trouble_; ++k) step();
  if (!trouble_) ++frame_;
  return trouble_;
}

particles::State SceneRun::state() const {
  particles::State all{Eigen::VectorXd(size_), Eigen::VectorXd(size_)};
  Eigen::Index at = 0;
  for (int i = 0; i < bodies(); ++i) {
    const int size = body(i).size();
    body(i).read(all.x.segment(at, size), all.v.segment(at, size));
    at += size;
  }
  return all;
}

std::vector<int> SceneRun::sizes() const {
  std::vector<int> all;
  for (std::size_t i = 0; i < strands_.size(); ++i) all.push_back(body(static_cast<int>(i)).size() / 3);
  return all;
}

const std::vector<Obstacle>& SceneRun::obstacles() const {
  return simulation_ ? simulation_->obstacles() : still_;
}

particles::State SceneRun::centre_lines(const particles::State& all) const {
  check_size(all);
  Eigen::Index points = 0;
  for (int i = 0; i < bodies(); ++i) points += body(i).points();
  particles::State lines{Eigen::VectorXd(3 * points), Eigen::VectorXd(3 * points)};
  Eigen::Index at = 0, to = 0;
  for (int i = 0; i < bodies(); ++i) {
    const int size = body(i).size(), numbers = 3 * body(i).points();
    body(i).centre_line(all.x.segment(at, size), all.v.segment(at, size), lines.x.segment(to, numbers),
                        lines.v.segment(to, numbers));
    at += size;
    to += numbers;
  }
  return lines;
}

const MeshRecord* SceneRun::mesh_record() const {
  return simulation_ ? simulation_->mesh_record() : nullptr;
}

const Watch& SceneRun::watch() const {
  return simulation_ ? simulation_->watch() : nothing_;
}

std::vector<Warning> SceneRun::warnings() const {
  std::vector<Warning> all = watch().warnings(), of_toys = toys_watch_.warnings();
  for (Warning& one : all)
    if (one.concern->of_solver) one.solver = solver_;
  for (Warning& one : of_toys) {
    one.body = "toy";
    if (one.concern->of_solver) one.solver = toys_[static_cast<std::size_t>(one.strand)]->solver();
    all.push_back(one);
  }
  return all;
}

Work SceneRun::work() const {
  Work work = simulation_ ? simulation_->work() : Work{};
  work.solver_steps += toys_work_.solver_steps;
  work.solves += toys_work_.solves;
  work.unconverged += toys_work_.unconverged;
  return work;
}

FrameMeasures SceneRun::measure(const particles::State& all) const {
  check_size(all);
  FrameMeasures sum;
  Eigen::Index at = 0;
  for (int i = 0; i < bodies(); ++i) {
    const int size = body(i).size();
    add(sum, body(i).measure(all.x.segment(at, size), all.v.segment(at, size)));
    at += size;
  }
  // Strands come first, and those of a mesh have positions.
  if (mesh_record()) sum.potential += simulation_->mesh_energy(all.x.head(mesh_size_));
  return sum;
}

void SceneRun::check_size(const particles::State& all) const {
  particles::require(all.x.size() == size_ && all.v.size() == size_, "the numbers of a state",
                     static_cast<double>(all.x.size()), std::to_string(size_));
}

const Body& SceneRun::body(int i) const {
  const auto index = static_cast<std::size_t>(i);
  if (index < strands_.size()) return simulation_->body(i);
  return *toys_[index - strands_.size()];
}

void SceneRun::ride(const Scene& scene) {
  riding_.clear();
  held_ = hand_ = {};
  for (const Rider& rider : scene.riders) riding_.emplace_back(rider, scene.hair);
}

void SceneRun::add_toys(const std::vector<Toy>& toys) {
  int rows = 0, columns = 0;
  for (const Toy& toy : toys) {
    const ToyBody& body = *toys_.emplace_back(std::make_unique<ToyBody>(toy, watched_));
    rows = std::max(rows, body.scratch_rows());
    columns = std::max(columns, body.scratch_columns());
  }
  scratch_.setZero(rows, columns);
}

void SceneRun::step() {
  const double time = static_cast<double>(steps_++) * h_;
  for (const Riding& riding : riding_) riding.lead(*simulation_, time, h_, held_, hand_);
  held_ = hand_;
  if (simulation_)
    if (const auto blow_up = simulation_->step())
      trouble_ = trouble("strand", blow_up->strand, blow_up->step, blow_up->stage);
  const BodyStep step{h_, tolerance_, still_};
  for (std::size_t i = 0; i < toys_.size() && !trouble_; ++i) {
    if (const auto stage = toys_[i]->step(step, scratch_.topRows(toys_[i]->scratch_rows()), toys_work_))
      trouble_ = trouble("toy", static_cast<int>(i), steps_, *stage);
    else if (watched_)
      toys_watch_.see(static_cast<int>(i), steps_, toys_[i]->sizes());
  }
}

}  // namespace hair
