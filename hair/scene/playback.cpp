#include "hair/scene/playback.h"

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <string>

#include "hair/scene/riding.h"
#include "hair/strand/measures.h"
#include "particles/require.h"
#include "particles/system.h"
#include "particles/toys/moving_toy.h"

namespace hair {

namespace {

void add(FrameMeasures& sum, double stretch, double kinetic, double potential, const Vector3d& momentum,
         const Vector3d& angular_momentum) {
  if (!(stretch <= sum.stretch)) sum.stretch = stretch;  // and if it is NaN
  sum.kinetic += kinetic;
  sum.potential += potential;
  sum.momentum += momentum;
  sum.angular_momentum += angular_momentum;
}

bool is_sound(const particles::State& state) {
  return (state.x.array().abs() <= kFarthest).all() && (state.v.array().abs() <= kFastest).all();
}

void check_times(const Scene& scene) {
  particles::require_at_least("the steps of a frame", scene.steps_per_frame, 1);
  particles::require_positive("the frames of a second", scene.frames_per_second);
  particles::require_positive("the step", scene.hair.step);
}

}  // namespace

class Playback::Parts {
 public:
  explicit Parts(const Scene& scene)
      : options_{scene.hair.step, scene.hair.tolerance},
        steps_per_frame_(scene.steps_per_frame),
        frames_per_second_(scene.frames_per_second),
        still_(scene.hair.obstacles) {
    check_times(scene);
    if (!scene.hair.strands.empty()) simulation_.emplace(scene.hair);
    if (simulation_)
      for (const Rider& rider : scene.riders) riding_.emplace_back(rider, scene.hair);
    add_toys(scene.toys);
    for (const StrandStart& start : scene.hair.strands) strands_.push_back(start.strand.count());
    size_ = 0;
    for (const int count : strands_) size_ += 3 * count;
    for (const MovingToy& toy : toys_) size_ += static_cast<int>(toy.state.x.size());
  }

  void restart(const Scene& scene) {
    check_times(scene);
    particles::require(scene.toys.size() == toys_.size(), "the toys of a scene that starts anew",
                       static_cast<double>(scene.toys.size()), std::to_string(toys_.size()));
    if (simulation_) simulation_->restart(scene.hair);
    scratch_.setZero();
    for (MovingToy& toy : toys_) {
      toy.state = toy.toy.start;
      toy.solves = {};
    }
    options_.h = scene.hair.step;
    steps_per_frame_ = scene.steps_per_frame;
    frames_per_second_ = scene.frames_per_second;
    frame_ = 0;
    steps_ = 0;
    trouble_.reset();
  }

  std::optional<std::string> advance() {
    for (int k = 0; k < steps_per_frame_ && !trouble_; ++k) step();
    if (!trouble_) ++frame_;
    return trouble_;
  }

  double time() const { return frame_ / frames_per_second_; }
  int frame() const { return frame_; }
  long steps() const { return steps_; }
  const std::vector<int>& strands() const { return strands_; }
  const std::vector<Obstacle>& obstacles() const { return simulation_ ? simulation_->obstacles() : still_; }

  particles::State state() const {
    particles::State all{Eigen::VectorXd(size_), Eigen::VectorXd(size_)};
    Eigen::Index at = 0;
    const auto put = [&](const particles::State& state) {
      all.x.segment(at, state.x.size()) = state.x;
      all.v.segment(at, state.v.size()) = state.v;
      at += state.x.size();
    };
    for (std::size_t i = 0; i < strands_.size(); ++i) put(simulation_->state(static_cast<int>(i)));
    for (const MovingToy& toy : toys_) put(toy.state);
    return all;
  }

  Work work() const {
    Work work = simulation_ ? simulation_->work() : Work{};
    for (const MovingToy& toy : toys_) {
      work.solver_steps += toy.solves.steps;
      work.unconverged += toy.solves.unconverged;
    }
    return work;
  }

  FrameMeasures measure(const particles::State& all) const {
    particles::require(all.x.size() == size_ && all.v.size() == size_, "the numbers of a state",
                       static_cast<double>(all.x.size()), std::to_string(size_));
    FrameMeasures sum;
    Eigen::Index at = 0;
    particles::State state;
    const auto take = [&](Eigen::Index size) {
      state.x = all.x.segment(at, size);
      state.v = all.v.segment(at, size);
      at += size;
    };
    for (int i = 0; i < static_cast<int>(strands_.size()); ++i) {
      take(3 * strands_[i]);
      const Measures part =
          hair::measure(simulation_->strand(i), simulation_->particles(i), simulation_->force(i), state);
      add(sum, part.stretch, part.kinetic, part.potential, part.momentum,
          part.angular_momentum + Vector3d(state.x.head<3>()).cross(part.momentum));
    }
    for (const MovingToy& toy : toys_) {
      take(toy.state.x.size());
      const particles::Particles& bodies = toy.toy.particles;
      add(sum, largest_stretch(toy.toy, state.x), particles::kinetic_energy(bodies, state.v),
          toy.force.energy(state.x), particles::momentum(bodies, state.v),
          particles::angular_momentum(bodies, state.x, state.v));
    }
    return sum;
  }

 private:
  void add_toys(const std::vector<Toy>& toys) {
    Eigen::Index rows = 0;
    int columns = 0;
    for (const Toy& toy : toys) {
      const MovingToy& moving = toys_.emplace_back(toy);
      toy_steps_.push_back(toy_step_of(toy.method));
      rows = std::max(rows, moving.state.x.size());
      columns = std::max(columns, toy_steps_.back().scratch);
    }
    scratch_.setZero(rows, columns);
  }

  void step() {
    const double time = static_cast<double>(steps_++) * options_.h;
    for (const Riding& riding : riding_) riding.lead(*simulation_, time, options_.h);
    if (simulation_)
      if (const auto blow_up = simulation_->step())
        trouble_ = "strand " + std::to_string(blow_up->strand) + ", step " + std::to_string(blow_up->step) +
                   ": " + stage_name(blow_up->stage);
    for (std::size_t i = 0; i < toys_.size() && !trouble_; ++i) {
      toy_steps_[i].step(toys_[i], options_, scratch_.topRows(toys_[i].state.x.size()));
      if (!is_sound(toys_[i].state))
        trouble_ = "toy " + std::to_string(i) + ", step " + std::to_string(steps_) + ": " +
                   stage_name(toys_[i].dynamics ? Stage::integration : Stage::filter);
    }
  }

  StepOptions options_;
  int steps_per_frame_;
  double frames_per_second_;
  std::optional<Simulation> simulation_;  // none without strands
  std::vector<Riding> riding_;
  std::deque<MovingToy> toys_;      // never moves what it holds
  std::vector<ToyStep> toy_steps_;  // of each toy
  Eigen::MatrixXd scratch_;         // shared by the toys, which take turns
  std::vector<Obstacle> still_;     // without strands nothing moves them
  std::vector<int> strands_;
  int size_ = 0;
  int frame_ = 0;
  long steps_ = 0;
  std::optional<std::string> trouble_;
};

Playback::Playback(const Scene& scene) : parts_(std::make_unique<Parts>(scene)) {}
Playback::~Playback() = default;

void Playback::restart(const Scene& scene) {
  parts_->restart(scene);
}
std::optional<std::string> Playback::advance() {
  return parts_->advance();
}
double Playback::time() const {
  return parts_->time();
}
int Playback::frame() const {
  return parts_->frame();
}
long Playback::steps() const {
  return parts_->steps();
}
particles::State Playback::state() const {
  return parts_->state();
}
const std::vector<int>& Playback::strands() const {
  return parts_->strands();
}
const std::vector<Obstacle>& Playback::obstacles() const {
  return parts_->obstacles();
}
Work Playback::work() const {
  return parts_->work();
}
FrameMeasures Playback::measure(const particles::State& state) const {
  return parts_->measure(state);
}

}  // namespace hair
