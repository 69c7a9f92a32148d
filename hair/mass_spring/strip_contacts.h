// Which particles of guides are near strips that are not their own, and on which side of them.
//
// Contacts are looked for once a step, within the strip's thickness r of it. A particle that moves by more
// than that in a step,
//
//   h |v . n| > r         v: relative to the strip, n: the strip's normal
//
// may be on its other side before it touched. If it is near the strip then, it still belongs to the side that
// it came from, and is pushed back. If it is farther away, which takes h |v . n| > 2r where it came from
// outside of r, it has gone through: that is counted (passes), and nothing pulls it back. A particle that was
// pushed too softly, and leaves at the wrong side, counts, too.
#pragma once

#include <span>
#include <vector>

#include "hair/mass_spring/control_mesh.h"
#include "hair/static_links.h"

namespace hair {

class StripContacts {
 public:
  // Particles of guide g: first[g] to first[g + 1] - 1. Keeps a reference to the mesh.
  StripContacts(const ControlMesh& mesh, std::vector<int> first);

  // The contacts at x. A particle touches a strip at most once, and not by its root. As long as it touches,
  // it belongs to the side where it was before it first did: what goes through is pushed back. The order is
  // that of strips, then of particles. Memory grows when more touch than ever did.
  void find(Input x, Input tangents);

  std::span<const StripContact> all() const { return contacts_; }

  // How often particles of this guide went through strips, as seen from one call of find() to the next.
  int passes(int guide) const { return passes_[static_cast<std::size_t>(guide)]; }

  void forget();

 private:
  struct Box {
    Eigen::Array3d low, high;
    void grow(const Box& other);
    void grow(double by);
    bool meets(const Box& other) const;
  };
  // Of a particle at a strip.
  struct Side {
    int strip, point;
    double side;
  };

  static Box around(Input x, int particle);
  Box swept(Input x, int particle) const;
  double side_of(int strip, int point, const std::array<int, 3>& triangle, Input x) const;
  bool passed(int point, const std::array<int, 3>& triangle, double side, Input x) const;
  void touch(int strip, int guide, int point, Input x, Input tangents);
  void touch_all(int strip, Input x, Input tangents);

  const ControlMesh& mesh_;
  std::vector<int> first_;
  std::vector<Box> boxes_;      // of guides, on their way since the last call
  std::vector<Box> triangles_;  // of the present strip's triangles, and what is near them
  Eigen::VectorXd last_;        // x of the last call
  bool moved_ = false;          // there was one
  std::vector<int> passes_;
  std::vector<StripContact> contacts_;
  std::vector<Side> sides_, before_;  // of contacts_, and of those of the step before
};

}  // namespace hair
