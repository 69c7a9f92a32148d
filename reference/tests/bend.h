// STAFF ONLY. H2's functions with results instead of sums, and the lecture's circle.
#pragma once

#include "hair/angular_springs.h"
#include "hair/strand/tests/strand_states.h"

namespace reference_tests {

VectorXd bend_force(const Strand& strand, const VectorXd& x);
VectorXd bend_product(const Strand& strand, const VectorXd& x, const VectorXd& dx);
VectorXd bend_product_spd(const Strand& strand, const VectorXd& x, const VectorXd& dx);
MatrixXd bend_matrix(const Strand& strand, const VectorXd& x);
MatrixXd bend_matrix_spd(const Strand& strand, const VectorXd& x);

// A circle of radius R as a regular polygon of n sides, gone round once and one side more, so that all n
// corners are joints. Rest lengths are the sides.
Strand circle_strand(int n, double R, double EI);
VectorXd circle(int n, double R);

}  // namespace reference_tests
