#include "hair/dense/synthesis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hair/dense/disorder.h"
#include "hair/dense/scalp_map.h"
#include "hair/strand/turns.h"
#include "hair/strand/variation.h"
#include "particles/require.h"

namespace hair {
namespace {

constexpr int kChildrenOfATask = 64;

void require_roots(const std::vector<RootFrame>& roots, const std::string& what) {
  for (const RootFrame& root : roots)
    particles::require(root.position.allFinite() && std::abs(root.axis.norm() - 1) < 1e-9, what,
                       root.axis.norm(), "finite, with an axis of length 1");
}

SynthesisDescription checked(SynthesisDescription description, int threads) {
  particles::require_at_least("the guides", static_cast<int>(description.guides.size()), 1);
  particles::require_at_least("the points of a strand", description.points, 2);
  particles::require_at_least("the threads", threads, 1);
  particles::require_at_least("the strands of a clump", description.clump, 0);
  for (const double part : {description.gathered, description.fly_aways})
    particles::require(part >= 0 && part <= 1, "a part of synthesis", part, "0 to 1");
  require_roots(description.guides, "a guide's root");
  require_roots(description.children, "a child's root");
  return description;
}

void require_numbers(bool holds, const char* what, std::size_t numbers, std::size_t needed) {
  if (!holds)
    particles::require(false, what, static_cast<double>(numbers), std::to_string(needed) + " numbers");
}

}  // namespace

Vector3d side_along_scalp(const Vector3d& pole, const Vector3d& normal) {
  return turn_between(pole, normal) * side_of(pole);
}

Synthesis::Synthesis(SynthesisDescription description, int threads)
    : given_(checked(std::move(description), threads)), threads_(threads), n_(given_.points) {
  const std::vector<RootFrame>& guides = given_.guides;
  std::vector<RootFrame> all = guides;
  all.insert(all.end(), given_.children.begin(), given_.children.end());
  const ScalpMap map(all);
  parents_ = find_parents(map, given_.guides, given_.children);
  if (given_.combed) keep_to_side_of_parting(given_.guides, given_.children, parents_);
  for (std::vector<RootFrame>* roots : {&given_.guides, &given_.children})
    for (RootFrame& root : *roots) root.side = side_along_scalp(map.pole(), root.axis);
  spreads_.resize(parents_.size());
  sizes_.resize(parents_.size());
  Variation variation(given_.seed);
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    spreads_[i] = given_.spread * (1 + given_.jitter * variation.uniform(-1, 1));
    sizes_[i] = 1 + given_.length * variation.uniform(-1, 1);
  }
  disorder_ = std::make_unique<Disorder>(given_);
  roots_.resize(guides.size());
  boxes_.resize(guides.size());
  in_use_.resize(guides.size());
  outside_.resize(parents_.size());
  in_view_.reserve(parents_.size());
  if (wisps())
    frames_.assign(guides.size(), {Eigen::VectorXd(n_), std::vector<Matrix3d>(static_cast<std::size_t>(n_))});
  scratch_.setZero(3 * n_, 2 * threads);
}

Synthesis::~Synthesis() = default;

double Synthesis::disorder(int child, double far) const {
  return disorder_->reach(child, far);
}

// Calls task(thread, i) for each i. A function object no larger than a pointer needs no allocation.
template <class Task>
void Synthesis::run(int count, const Task& task) {
  struct Batches {
    const Task& one;
    int count;
  } const batches{task, count};
  const StrandThreads::Task batch = [&batches](int thread, int b) {
    const int end = std::min(batches.count, (b + 1) * kChildrenOfATask);
    for (int i = b * kChildrenOfATask; i < end; ++i) batches.one(thread, i);
  };
  threads_.run((count + kChildrenOfATask - 1) / kChildrenOfATask, batch);
}

SynthesisCounts Synthesis::make(std::span<const double> guides, const ScalpTurn& turn,
                                std::span<const Plane> view, std::span<double> strands) {
  const std::size_t each = 3 * static_cast<std::size_t>(n_);
  require_numbers(guides.size() == each * given_.guides.size(), "the guides' numbers", guides.size(),
                  each * given_.guides.size());
  require_numbers(strands.size() >= each * parents_.size(), "the room for strands", strands.size(),
                  each * parents_.size());
  points_ = guides.data();
  turn_ = turn;
  place_guides(!view.empty());
  choose(view);
  if (wisps())
    run(static_cast<int>(given_.guides.size()), [this](int, int guide) {
      if (in_use_[guide] & kWisp) carry_along(this->guide(guide).points, frames_[guide]);
    });
  run(static_cast<int>(in_view_.size()), [this, strands, each](int thread, int i) {
    make_child(thread, in_view_[i], strands.data() + each * static_cast<std::size_t>(i));
  });
  SynthesisCounts counts;
  counts.children = static_cast<int>(in_view_.size());
  counts.children_out_of_view = children() - counts.children;
  counts.guides_idle = static_cast<int>(std::count(in_use_.begin(), in_use_.end(), 0));
  counts.guides_used = static_cast<int>(in_use_.size()) - counts.guides_idle;
  return counts;
}

GuideHair Synthesis::guide(int i) const {
  return {roots_[i], {points_ + static_cast<std::size_t>(3 * n_) * static_cast<std::size_t>(i), 3 * n_}};
}

// Sets the guides' present roots, and, for the view, the boxes that hold the guides.
void Synthesis::place_guides(bool with_boxes) {
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    const RootFrame& start = given_.guides[i];
    const GuideHair now = guide(static_cast<int>(i));
    roots_[i] = {Vector3d(now.points.head<3>()), turn_ * start.axis, turn_ * start.side};
    if (!with_boxes) continue;
    boxes_[i] = box_of_strand(roots_[i], now.points);
  }
}

// The root moves with the nearest guide's root.
RootFrame Synthesis::child_root(int child) const {
  const RootFrame& start = given_.children[static_cast<std::size_t>(child)];
  const int nearest = parents_[child].guides[0];
  return {roots_[nearest].position + turn_ * (start.position - given_.guides[nearest].position),
          turn_ * start.axis, turn_ * start.side};
}

// The largest distance of a child from its root along `direction`. A mean of guides, in their roots'
// frames, reaches as far as the mean of their boxes; a wisp's strand is near its guide.
double Synthesis::reach_of(int child, const RootFrame& root, const Vector3d& direction) const {
  const Parents& parents = parents_[child];
  double reach = -std::numeric_limits<double>::infinity();
  if (shapes()) {
    const Vector3d seen = axes_of_root(root).transpose() * direction;
    reach = 0;
    for (int k = 0; k < 3; ++k) reach += parents.weights[k] * boxes_[parents.guides[k]].reach(seen);
  }
  if (wisps()) {
    const int nearest = parents.guides[0];
    const Vector3d between = root.position - roots_[nearest].position;
    reach = std::max(reach, boxes_[nearest].reach(axes_of_root(roots_[nearest]).transpose() * direction) -
                                direction.dot(between) + std::max(1.0, spreads_[child]) * between.norm());
  }
  return sizes_[child] * (reach + disorder_->reach(child, farthest(parents, root)));
}

// A bound for the distance of a child's points from its root.
double Synthesis::farthest(const Parents& parents, const RootFrame& root) const {
  double far = 0;
  for (const int guide : parents.guides) far = std::max(far, boxes_[guide].farthest());
  const double between = (root.position - roots_[parents.guides[0]].position).norm();
  return far + (1 + given_.spread * (1 + given_.jitter)) * between;
}

bool Synthesis::is_out_of(std::span<const Plane> view, int child) const {
  const RootFrame root = child_root(child);
  return std::any_of(view.begin(), view.end(), [&](const Plane& plane) {
    return plane.normal.dot(root.position - plane.point) + reach_of(child, root, plane.normal) < 0;
  });
}

void Synthesis::choose(std::span<const Plane> view) {
  if (!view.empty())
    run(children(), [this, view](int, int child) { outside_[child] = is_out_of(view, child); });
  in_view_.clear();
  std::fill(in_use_.begin(), in_use_.end(), char{0});
  for (int child = 0; child < children(); ++child) {
    if (!view.empty() && outside_[child]) continue;
    in_view_.push_back(child);
    const Parents& parents = parents_[child];
    for (int k = 0; k < 3; ++k)
      if (shapes() && parents.weights[k] > 0) in_use_[parents.guides[k]] |= kShape;
    if (wisps()) in_use_[parents.guides[0]] |= kWisp;
  }
}

void Synthesis::make_child(int thread, int child, double* strand) {
  const RootFrame root = child_root(child);
  const Parents& parents = parents_[child];
  auto made = scratch_.col(2 * thread), wisp = scratch_.col(2 * thread + 1);
  const int nearest = parents.guides[0];
  if (shapes())
    interpolate({guide(nearest), guide(parents.guides[1]), guide(parents.guides[2])}, parents.weights, root,
                made);
  if (wisps())
    extrapolate(guide(nearest).points, frames_[nearest], root.position, spreads_[child],
                shapes() ? wisp : made);
  if (shapes() && wisps()) blend(frames_[nearest].arc, made, wisp, made);
  const std::span<const Matrix3d> none;
  disorder_->apply(child, root, turn_, wisps() ? frames_[parents.guides[0]].turns : none, made);
  const double size = sizes_[child];
  for (int at = 0; at < 3 * n_; at += 3)
    for (int axis = 0; axis < 3; ++axis)
      strand[at + axis] = root.position[axis] + size * (made[at + axis] - root.position[axis]);
}

}  // namespace hair
