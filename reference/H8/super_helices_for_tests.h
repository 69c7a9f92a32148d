// STAFF ONLY. Super-helices for tests.
#pragma once

#include "hair/super_helix/helix_forces.h"
#include "reference/H7/link_trees_for_tests.h"

namespace reference_tests {

using hair::HelixMotion, hair::HelixRoot, hair::HelixStrand;

// Human hair of equal elements, with the same natural curvatures in each.
HelixStrand hair_strand(int elements, double length, const Vector3d& natural = Vector3d::Zero());

// Coordinates of a curl that winds by up to `angle` in each element.
VectorXd random_curl(const HelixStrand& strand, double angle, RandomNumbers& numbers);

HelixRoot random_root(RandomNumbers& numbers);

// A start at no special place, in no special direction.
hair::MaterialFrame some_start();

// Calls helix_step with the scratch memory that it needs.
VectorXd helix_step(const HelixMotion& motion, const VectorXd& q, const VectorXd& rates, double h);

}  // namespace reference_tests
