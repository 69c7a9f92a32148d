#include "hair/truth/rigid_links_ode.h"

#include "hair/simulation/rigid_links_strand.h"
#include "hair/truth/model_ode.h"

namespace hair {

using Eigen::Quaterniond;
using Eigen::VectorXd;

namespace {

// 1/s. An error of a rate that oscillates with omega moves positions by 1/omega of it. This value is between
// a whole hair's few 1/s, and the 1e5 1/s of its joints' twists.
constexpr double kRate = 1000;

}  // namespace

LinksOde::LinksOde(const Problem& problem)
    : LinksOde(problem, links_of(problem.modelled()->spec, problem.scene.hair)) {}

LinksOde::LinksOde(const Problem& problem, const LinkStrand& strand)
    : scene_(problem.scene),
      root_(scene_),
      body_(modelled_body(problem)),
      system_(strand.tree, strand.forces),
      start_(strand.q.size() + strand.rates.size()),
      q_(strand.q) {
  system_.motion().place(strand.base, strand.tree.rest());
  for (const LinkFrame& frame : system_.motion().frames()) at_rest_.push_back(frame.orientation);
  start_ << strand.q, strand.rates;
  set_in_motion();
}

// Between before and after, the base accelerates without bounds for no time: rates change by the part that
// its velocity, taken as an acceleration, adds to accelerations.
void LinksOde::set_in_motion() {
  TreeBase base = base_at(0);
  const SpatialMotion velocity = base.velocity;
  const auto places = start_.head(tree().coordinates());
  auto rates = start_.tail(tree().rates());
  VectorXd moved(rates.size()), left(rates.size());
  base.velocity = base.acceleration = {};
  system_.accelerations(base, places, rates, 0, {}, left);
  base.acceleration = velocity;
  system_.accelerations(base, places, rates, 0, {}, moved);
  rates += moved - left;
}

VectorXd LinksOde::scales() const {
  VectorXd scales(size());
  scales << VectorXd::Ones(tree().coordinates()), VectorXd::Constant(tree().rates(), kRate);
  return scales;
}

TreeBase LinksOde::base_at(double t) const {
  const RootMotion root = root_.at(t);
  return {root.position,
          root_axes(root.tangent, root.normal),
          {root.angular_velocity, root.velocity},
          {root.angular_acceleration, root.acceleration}};
}

void LinksOde::rates(double t, particles::Input y, particles::Output dy) {
  const int places = tree().coordinates();
  q_ = y.head(places);
  tree().normalise(q_);
  system_.accelerations(base_at(t), q_, y.tail(tree().rates()), 0, {}, dy.tail(tree().rates()));
  system_.motion().derivative(q_, y.tail(tree().rates()), dy.head(places));
}

particles::State LinksOde::state(double t, particles::Input y) {
  const TreeBase base = base_at(t);
  q_ = y.head(tree().coordinates());
  tree().normalise(q_);
  system_.motion().place(base, q_);
  const std::vector<LinkFrame>& frames = system_.motion().frames();
  particles::State state{VectorXd(3 * tree().links()), VectorXd(3 * tree().links())};
  state.x.head<3>() = base.position;
  state.v.head<3>() = base.velocity.linear;
  Vector3d omega = base.velocity.angular;
  for (int i = 1; i < tree().links(); ++i) {
    omega += y.segment<3>(tree().coordinates() + tree().rate(i));
    const Vector3d turn = turn_of((frames[i].orientation * at_rest_[i].conjugate()).normalized());
    state.x.segment<3>(3 * i) = turn;
    state.v.segment<3>(3 * i) = rate_of_turn(turn) * omega;
  }
  return state;
}

VectorXd LinksOde::points(const particles::State& state) const {
  VectorXd x(3 * body_->points()), v(x.size());
  body_->centre_line(state.x, state.v, x, v);
  return x;
}

std::unique_ptr<Ode> rigid_links_ode(const Problem& problem) {
  return std::make_unique<LinksOde>(problem);
}

}  // namespace hair
