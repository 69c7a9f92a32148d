// Synthesis: dense hair of guides. Each strand that is drawn, a child, grows at a root of its own between
// three guides and is made from them by the functions of H10 (hair/strand_synthesis.h). Which guides those
// are is found once, by a triangulation of the guides' roots along the scalp; then each frame makes all
// children anew, from the guides as they lie then, in one pass over threads. A frame allocates nothing, and
// its bits do not depend on the number of threads.
//
// A frame leaves out what nobody sees: children outside of the view, and guides that none of the others
// needs.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hair/head/parents.h"
#include "hair/strand/obstacles.h"
#include "hair/strand/rest_shape.h"

namespace hair {

// interpolate: between three guides. extrapolate: beside the nearest of them, as a strand of its wisp. blend:
// the first at the root, the second at the tip.
enum class SynthesisMode { interpolate, extrapolate, blend };

struct SynthesisDescription {
  // Where guides and children grow at the start, m. Of a root's frame, axis is the scalp's outward normal;
  // sides are chosen here.
  std::vector<RootFrame> guides = {}, children = {};
  int points = 2;  // of each guide and each child, n >= 2
  SynthesisMode mode = SynthesisMode::blend;
  double spread = 1;  // of wisps: their width at the tips, over that at the roots
  double jitter = 0;  // a child's own spread is the spread times 1 - jitter to 1 + jitter
  double length = 0;  // a child's size is 1 - length to 1 + length times that of what its guides make
  std::uint64_t seed = 0;
  // The sides of all roots are how hair is combed there: no strand is made of guides on the other side of a
  // parting.
  bool combed = false;
  // Locks beside the guides' own: about so many strands grow towards a common one of them. 0: none.
  int clump = 0;
  double gathered = 0;   // how much of the way to it a tip is
  double fly_aways = 0;  // this part of the strands stands out from the others, and is in no clump
};

// Where the scalp is now: it has turned as a whole since the start. Where its roots are, the guides say.
using ScalpTurn = Eigen::Matrix3d;

struct SynthesisCounts {
  int children = 0, children_out_of_view = 0;
  int guides_used = 0, guides_idle = 0;  // idle: no child in view is made of it
};

class Synthesis {
 public:
  // Throws std::invalid_argument for less than one guide, two points or one thread, and for guides or
  // children that are not finite; and if the course leaves H10 out. Calls root_weights for each child.
  explicit Synthesis(SynthesisDescription description, int threads = 1);
  ~Synthesis();
  Synthesis(const Synthesis&) = delete;
  Synthesis& operator=(const Synthesis&) = delete;

  int children() const;
  int points() const;
  const Parents& parents(int child) const;
  // How far clumps and fly-aways move a child's points at most, whose guides end at most `far` from its root.
  double disorder(int child, double far) const;

  // The children that are in the view, one after the other, n points each: their coordinates go to `strands`,
  // which has room for all children, and their numbers to in_view(). guides: guide after guide, n points
  // each. view: the half-spaces whose common part is seen; none: everything is. A child is left out if a box
  // that holds it lies outside of one.
  SynthesisCounts make(std::span<const double> guides, const ScalpTurn& turn, std::span<const Plane> view,
                       std::span<double> strands);
  SynthesisCounts make(std::span<const double> guides, const ScalpTurn& turn, std::span<const Plane> view,
                       std::span<float> strands);

  std::span<const int> in_view() const;           // as the last call of make found it
  const std::vector<char>& guide_in_use() const;  // 0: idle, and need not have been simulated

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

// A frame for each normal along a scalp, without a jump between neighbours: the frame of `pole`, turned by
// the least rotation that takes the pole to the normal. Only opposite to the pole there is none that fits.
Vector3d side_along_scalp(const Vector3d& pole, const Vector3d& normal);

}  // namespace hair
