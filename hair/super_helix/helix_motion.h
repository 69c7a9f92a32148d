// Moves a super-helix: calculates positions and velocities of its elements and points from its coordinates,
// for H8's functions.
//
// Points are the nodes of Gauss's quadrature, 8 in each panel. An element that winds by the angle a has
// ceil(a / 2) panels, so that none winds by more than 2. M's integrand has terms up to exp(2 i a s / l), and
// 8 nodes integrate exp(i z w) over -1 <= z <= 1 to 2.2e-18 w^16: the relative error is at most 1.4e-13, and
// 0 for a straight strand.
#pragma once

#include <vector>

#include "hair/super_helix.h"

namespace hair {

// The root's motion is given.
struct HelixRoot {
  MaterialFrame frame;
  Vector3d velocity = Vector3d::Zero();           // m/s, of the frame's position
  Vector3d spin = Vector3d::Zero();               // rad/s, angular velocity of the frame
  Vector3d acceleration = Vector3d::Zero();       // m/s^2
  Vector3d spin_acceleration = Vector3d::Zero();  // rad/s^2
};

class HelixMotion {
 public:
  // places: m from the root along the hair, from 0 to its length: points in addition to the nodes, for forces
  // that push or hold the hair there. They have no mass.
  explicit HelixMotion(HelixStrand strand, std::vector<double> places = {});

  const HelixStrand& strand() const { return strand_; }

  std::vector<HelixElement> elements;
  std::vector<HelixPoint> points;   // their number depends on q: see above
  std::vector<std::size_t> placed;  // for each place: the index of its point

  // For each point: the length of its piece of hair, m (0 at a place); velocity, m/s; acceleration at q" = 0,
  // m/s^2.
  std::vector<double> weights;
  std::vector<Vector3d> velocities, accelerations;

  // Sets elements, points and weights. Points have their mass and no force. Allocates nothing, unless the
  // strand winds more than ever before.
  void place(const MaterialFrame& root, Input q);

  // For the placed strand: move() sets velocities; accelerate() sets accelerations, which steps with momenta
  // don't need.
  void move(const HelixRoot& root, Input rates);
  void accelerate(const HelixRoot& root, Input rates);

 private:
  void add_nodes(int element);
  void add_point(int element, double s, double weight);

  HelixStrand strand_;
  struct Place {
    int element;
    double s;  // m, in the element
    std::size_t number;
  };
  std::vector<Place> places_;  // from the root on
};

}  // namespace hair
