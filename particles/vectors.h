// Vectors as arguments of functions. Each particle has three numbers: a vector for n particles has 3n
// entries, and x.segment<3>(3 * i) belongs to particle i, counted from 0.
//
// Input and Output are views of an Eigen::VectorXd, of a part of one, or of an array through Eigen::Map.
// Nothing is copied, and an Output can't change its size. Unless a function says otherwise, no Output
// overlaps another argument.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace particles {

using Eigen::Vector3d;

using Input = const Eigen::Ref<const Eigen::VectorXd>&;
using Output = Eigen::Ref<Eigen::VectorXd>;

// Memory for intermediate results: at least as many columns of 3n numbers as the function asks for. Their
// values on entry are arbitrary, and so are their values on return. A function that is given scratch
// allocates nothing: assignment/README.md defines which allocations count.
using Scratch = Eigen::Ref<Eigen::MatrixXd>;

}  // namespace particles
