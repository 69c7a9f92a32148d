// A chain or tree of rigid links: the constants of its motion. The base is link 0; shapes()[i] belongs to
// link i.
//
// A link's axes are its principal axes, fixed in it. At rest (q = 0) they are turned by `rest` against the
// parent's axes; then the joint turns or moves the link:
//
//   orientation_i = orientation_parent * rest * (the joint's turn)
#pragma once

#include <vector>

#include "hair/link.h"

namespace hair {

struct LinkShape {
  int parent = 0;  // less than the link's own number
  JointType joint = JointType::revolute;
  Vector3d axis = Vector3d(1, 0, 0);     // along the link's axes, of length 1; unused for a spherical joint
  Vector3d joint_at = Vector3d::Zero();  // m, from the parent's centre of mass, along the parent's axes
  Vector3d center = Vector3d::Zero();    // m, from the joint to the centre of mass, along the link's axes
  Eigen::Quaterniond rest = Eigen::Quaterniond::Identity();
  double mass = 0;                      // kg, > 0
  Vector3d moments = Vector3d::Zero();  // moments of inertia about the centre of mass, kg m^2
};

class LinkTree {
 public:
  // shapes[i] becomes link i + 1. Throws std::invalid_argument for values that are out of bounds or not
  // finite: a link without mass, a joint that turns no inertia (a link of no length and no moments), a parent
  // that comes later.
  explicit LinkTree(const std::vector<LinkShape>& shapes);

  const std::vector<LinkShape>& shapes() const { return shapes_; }  // shapes()[0], the base's, is empty
  int links() const { return static_cast<int>(shapes_.size()); }    // with the base

  // A revolute joint has an angle (rad), a prismatic joint a distance (m), a spherical joint a unit
  // quaternion, x y z w. coordinate(i) and rate(i) are the first indices for link i.
  int coordinates() const { return coordinates_; }
  int rates() const { return rates_; }
  int coordinate(int i) const { return places_[i].coordinate; }
  int rate(int i) const { return places_[i].rate; }

  Eigen::VectorXd rest() const;  // the coordinates at rest

  // Gives quaternions the length 1.
  void normalise(Eigen::Ref<Eigen::VectorXd> q) const;

  std::vector<Link> made_links() const;  // sets their constants; TreeMotion sets the rest

 private:
  struct Place {
    int coordinate, rate;
  };
  std::vector<LinkShape> shapes_;
  std::vector<Place> places_;
  int coordinates_ = 0, rates_ = 0;
};

}  // namespace hair
