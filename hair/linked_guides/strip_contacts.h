// Finds the particles of guides near strips of other guides, and their sides of these strips.
//
// Contacts are looked for once a step, within the strip's thickness r of it. A particle that moves by more
// than that in a step,
//
//   h |v . n| > r         v: relative to the strip, n: the strip's normal
//
// may be on its other side before it touched. If it is near the strip then, it still belongs to its old side,
// and is pushed back. If it is farther away (which takes h |v . n| > 2r for a particle from outside of r), it
// has gone through: `passes` counts it, and no force pulls it back. A particle that was pushed too softly,
// and leaves on the wrong side, counts, too.
#pragma once

#include <span>
#include <vector>

#include "hair/linked_guides/control_mesh.h"
#include "hair/static_links.h"

namespace hair {

class StripContacts {
 public:
  // Particles of guide g: first[g] to first[g + 1] - 1. Keeps a reference to the mesh.
  StripContacts(const ControlMesh& mesh, std::vector<int> first);

  // Finds the contacts at x. A particle touches a strip at most once, and never with its root. As long as it
  // touches, it belongs to the side on which it was before the contact: a particle that goes through is
  // pushed back. The order is that of strips, then of particles. Memory grows only with a new maximum of
  // contacts.
  void find(Input x, Input tangents);

  std::span<const StripContact> all() const { return contacts_; }

  // How often particles of this guide went through strips, from one call of find() to the next.
  int passes(int guide) const { return passes_[static_cast<std::size_t>(guide)]; }

  void forget();

 private:
  struct Box {
    Eigen::Array3d low, high;
    void grow(const Box& other);
    void grow(double by);
    bool meets(const Box& other) const;
  };
  // The side of a particle at a strip.
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
  std::vector<Box> boxes_;      // one for each guide, including its way since the last call
  std::vector<Box> triangles_;  // the present strip's triangles, and the boxes near them
  Eigen::VectorXd last_;        // x of the last call
  bool moved_ = false;          // false before the first call
  std::vector<int> passes_;
  std::vector<StripContact> contacts_;
  std::vector<Side> sides_, before_;  // for contacts_, and for the contacts of the previous step
};

}  // namespace hair
