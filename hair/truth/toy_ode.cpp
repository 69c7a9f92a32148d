#include <algorithm>

#include "hair/truth/ode.h"
#include "hair/truth/problem.h"
#include "particles/toys/moving_toy.h"

namespace hair {

namespace {

// Uses an explicit method: any of them sees the toy exactly.
Toy exact_toy(const Problem& problem) {
  Toy toy = problem.scene.toys.at(0);
  toy.method = ToyMethod::runge_kutta_4;
  return toy;
}

class ToyOde : public Ode {
 public:
  explicit ToyOde(const Problem& problem);

  int size() const override { return 6 * static_cast<int>(free_.size()); }
  Eigen::VectorXd start() const override;
  Eigen::VectorXd scales() const override;
  void rates(double t, particles::Input y, particles::Output dy) override;
  particles::State state(double t, particles::Input y) override;

 private:
  void unpack(double t, particles::Input y);

  particles::MovingToy moving_;
  std::vector<int> free_;  // particles
  double duration_;
  particles::State state_;
  Eigen::VectorXd acceleration_;
};

ToyOde::ToyOde(const Problem& problem)
    : moving_(exact_toy(problem)),
      duration_(problem.duration),
      state_(moving_.toy.start),
      acceleration_(moving_.toy.start.x.size()) {
  for (int i = 0; i < moving_.toy.particles.count(); ++i)
    if (!moving_.toy.particles.is_pinned(i)) free_.push_back(i);
}

Eigen::VectorXd ToyOde::start() const {
  const particles::State& state = moving_.toy.start;
  Eigen::VectorXd y(size());
  const int half = size() / 2;
  for (std::size_t k = 0; k < free_.size(); ++k) {
    y.segment<3>(3 * k) = state.x.segment<3>(3 * free_[k]);
    y.segment<3>(half + 3 * k) = state.v.segment<3>(3 * free_[k]);
  }
  return y;
}

// The size of the whole toy, with its supports; and this size over the duration, or the velocity at the
// start.
Eigen::VectorXd ToyOde::scales() const {
  const Toy& toy = moving_.toy;
  Eigen::Array3d low = toy.start.x.head<3>(), high = low;
  double fastest = 0;
  const auto reach = [&](const Eigen::Vector3d& place, double around) {
    low = low.min(place.array() - around);
    high = high.max(place.array() + around);
  };
  for (int i = 0; i < toy.particles.count(); ++i) {
    reach(toy.start.x.segment<3>(3 * i), 0);
    fastest = std::max(fastest, toy.start.v.segment<3>(3 * i).norm());
  }
  for (const particles::Wire& wire : toy.constraints.wires) reach(wire.centre, wire.radius);
  double size = (high - low).matrix().norm();
  for (const particles::Spring& spring : toy.springs) size = std::max(size, spring.rest_length);
  if (size == 0) size = 1;  // a lone particle gets the size of a metre
  Eigen::VectorXd scales(this->size());
  scales.head(this->size() / 2).setConstant(size);
  scales.tail(this->size() / 2).setConstant(std::max(fastest, size / duration_));
  return scales;
}

void ToyOde::unpack(double t, particles::Input y) {
  const int half = size() / 2;
  state_ = moving_.toy.start;
  state_.x += t * state_.v;  // for pinned particles
  for (std::size_t k = 0; k < free_.size(); ++k) {
    state_.x.segment<3>(3 * free_[k]) = y.segment<3>(3 * k);
    state_.v.segment<3>(3 * free_[k]) = y.segment<3>(half + 3 * k);
  }
}

void ToyOde::rates(double t, particles::Input y, particles::Output dy) {
  const int half = size() / 2;
  unpack(t, y);
  moving_.dynamics->acceleration(state_.x, state_.v, acceleration_);
  dy.head(half) = y.tail(half);
  for (std::size_t k = 0; k < free_.size(); ++k)
    dy.segment<3>(half + 3 * k) = acceleration_.segment<3>(3 * free_[k]);
}

particles::State ToyOde::state(double t, particles::Input y) {
  unpack(t, y);
  return state_;
}

}  // namespace

std::unique_ptr<Ode> toy_ode(const Problem& problem) {
  return std::make_unique<ToyOde>(problem);
}

}  // namespace hair
