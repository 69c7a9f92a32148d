// How vectors go in and out of functions. Three numbers belong to each particle: of n particles a vector has
// 3n, and x.segment<3>(3 * i) is what belongs to particle i, counted from 0.
//
// Both are views: of an Eigen::VectorXd, of a part of one, or of an array by way of Eigen::Map. Nothing is
// copied, and an Output can't change its size. Unless a function says otherwise, no Output overlaps another
// argument.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace particles {

using Eigen::Vector3d;

using Input = const Eigen::Ref<const Eigen::VectorXd>&;
using Output = Eigen::Ref<Eigen::VectorXd>;

// Memory for a step's intermediate results, so that it allocates nothing: columns of 3n numbers, as many as
// the function asks for or more. They hold anything on entry, and may hold anything on return.
using Scratch = Eigen::Ref<Eigen::MatrixXd>;

}  // namespace particles
