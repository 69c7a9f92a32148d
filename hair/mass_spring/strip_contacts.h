// Which particles of guides are near strips that are not their own, and on which side of them.
#pragma once

#include <span>
#include <vector>

#include "hair/static_links.h"

namespace hair {

class StripContacts {
 public:
  // Particles of guide g: first[g] to first[g + 1] - 1. Keeps a reference to the mesh.
  StripContacts(const ControlMesh& mesh, std::vector<int> first);

  // The contacts at x. A particle touches a strip at most once, and not by its root. As long as it touches, it
  // belongs to the side where it first did: what goes through is pushed back. The order is that of strips, then of
  // particles. Memory grows when more touch than ever did.
  void find(Input x, Input tangents);

  std::span<const StripContact> all() const { return contacts_; }
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
  double side_of(int strip, int point, const std::array<int, 3>& triangle, Input x) const;
  void touch(int strip, int point, Input x, Input tangents);
  void touch_all(int strip, Input x, Input tangents);

  const ControlMesh& mesh_;
  std::vector<int> first_;
  std::vector<Box> boxes_;  // of guides
  std::vector<StripContact> contacts_;
  std::vector<Side> sides_, before_;  // of contacts_, and of those of the step before
};

}  // namespace hair
