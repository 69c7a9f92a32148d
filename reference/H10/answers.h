// STAFF ONLY. A student's functions of H10, requested through the pipe.
#pragma once

#include "grader/judge/trial.h"
#include "reference/H10/hair.h"

namespace grader::h10 {

using Weights = std::array<double, 3>;

// Where a blend's child goes: into memory of its own, or over one of the strands that it is made of.
enum class Place { own, at_root, at_tip };

Weights ask_weights(Trial& trial, const Corners& corners, const Vector3d& root);
VectorXd ask_interpolated(Trial& trial, const std::array<OwnGuide, 3>& guides, const Weights& weights,
                          const RootFrame& root);
GuideFrames ask_frames(Trial& trial, const VectorXd& guide);
VectorXd ask_extrapolated(Trial& trial, const VectorXd& guide, const GuideFrames& frames,
                          const Vector3d& root, double spread);
VectorXd ask_blended(Trial& trial, const VectorXd& arc, VectorXd at_root, VectorXd at_tip, Place place);

}  // namespace grader::h10
