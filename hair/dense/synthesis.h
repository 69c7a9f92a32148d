// Synthesis: dense hair made of guides. Each drawn strand, a child, grows at a root of its own between three
// guides, and the functions of H10 (hair/strand_synthesis.h) make it from them. A triangulation of the
// guides' roots along the scalp finds these guides once; then each frame makes all children anew, from the
// guides as they lie then, in one pass over threads. A frame allocates nothing, and its bits do not depend on
// the number of threads.
//
// A frame leaves out invisible hair: children outside of the view, and guides that no other child needs.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hair/dense/parents.h"
#include "hair/dense/root_box.h"
#include "hair/obstacles/obstacles.h"
#include "hair/simulation/strand_threads.h"
#include "hair/strand/rest_shape.h"
#include "hair/strand_synthesis.h"

namespace hair {

// interpolate: between three guides. extrapolate: near the nearest of them, as a strand of its wisp. blend:
// interpolated at the root, extrapolated at the tip.
enum class SynthesisMode { interpolate, extrapolate, blend };

struct SynthesisDescription {
  // The roots of guides and children at the start, m. A root's axis is the scalp's outward normal; its side
  // is chosen here.
  std::vector<RootFrame> guides = {}, children = {};
  int points = 2;  // per guide and per child, n >= 2
  SynthesisMode mode = SynthesisMode::blend;
  double spread = 1;  // a wisp's width at the tips, over that at the roots
  double jitter = 0;  // a child's own spread is the spread times 1 - jitter to 1 + jitter
  double length = 0;  // a child's size is 1 - length to 1 + length times the one that its guides give
  std::uint64_t seed = 0;
  // The sides of all roots are the directions in which hair is combed there: no strand is made of guides on
  // the other side of a parting.
  bool combed = false;
  // Locks in addition to the guides' wisps: about so many strands grow towards a common one of them. 0: none.
  int clump = 0;
  double gathered = 0;   // the part of the distance to it that a tip closes
  double fly_aways = 0;  // the part of the strands that stands out from the others, and is in no clump
};

// The rotation of the whole scalp since the start. The guides give the positions of the roots.
using ScalpTurn = Eigen::Matrix3d;

struct SynthesisCounts {
  int children = 0, children_out_of_view = 0;
  int guides_used = 0, guides_idle = 0;  // idle: it makes no child in view
};

class Disorder;

class Synthesis {
 public:
  // Throws std::invalid_argument for less than one guide, two points or one thread, for guides or children
  // that are not finite, and if H10 is not in the course. Calls root_weights for each child.
  explicit Synthesis(SynthesisDescription description, int threads = 1);
  ~Synthesis();
  Synthesis(const Synthesis&) = delete;
  Synthesis& operator=(const Synthesis&) = delete;

  int children() const { return static_cast<int>(parents_.size()); }
  int points() const { return n_; }
  const Parents& parents(int child) const { return parents_[static_cast<std::size_t>(child)]; }
  // The largest distance by which clumps and fly-aways move a child's points, if its guides end at most `far`
  // from its root.
  double disorder(int child, double far) const;

  // Makes the children that are in the view, one after the other, n points each: their coordinates go to
  // `strands`, which has space for all children, and their numbers to in_view(). guides: guide after guide, n
  // points each. view: half-spaces whose common part is visible; none: everything is. A child is left out if
  // a box that holds it lies outside of one of them.
  SynthesisCounts make(std::span<const double> guides, const ScalpTurn& turn, std::span<const Plane> view,
                       std::span<double> strands);

  std::span<const int> in_view() const { return in_view_; }  // result of the last call of make

 private:
  static constexpr char kShape = 1, kWisp = 2;  // bits: the uses of a guide

  bool shapes() const { return given_.mode != SynthesisMode::extrapolate; }
  bool wisps() const { return given_.mode != SynthesisMode::interpolate; }
  template <class Task>
  void run(int count, const Task& task);
  GuideHair guide(int i) const;
  void place_guides(bool with_boxes);
  RootFrame child_root(int child) const;
  double reach_of(int child, const RootFrame& root, const Vector3d& direction) const;
  double farthest(const Parents& parents, const RootFrame& root) const;
  bool is_out_of(std::span<const Plane> view, int child) const;
  void choose(std::span<const Plane> view);
  void make_child(int thread, int child, double* strand);

  SynthesisDescription given_;
  StrandThreads threads_;
  int n_;
  std::vector<Parents> parents_;
  std::vector<double> spreads_, sizes_;  // for each child
  std::unique_ptr<Disorder> disorder_;

  const double* points_ = nullptr;
  ScalpTurn turn_;
  std::vector<RootFrame> roots_;  // the guides' present ones
  std::vector<RootBox> boxes_;
  std::vector<char> in_use_, outside_;
  std::vector<int> in_view_;
  std::vector<GuideFrames> frames_;
  Eigen::MatrixXd scratch_;  // two strands a thread
};

// A frame for each normal along a scalp, without a jump between neighbours: the frame of `pole`, turned by
// the least rotation that takes the pole to the normal. It is undefined only opposite to the pole.
Vector3d side_along_scalp(const Vector3d& pole, const Vector3d& normal);

}  // namespace hair
