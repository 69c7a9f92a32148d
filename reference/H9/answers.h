// STAFF ONLY. A student's functions of H9, requested through the pipe.
#pragma once

#include <optional>

#include "grader/judge/trial.h"
#include "reference/H9/mesh.h"

namespace grader::h9 {

double ask_strength(Trial& trial, const StaticLink& link, double largest);
VectorXd ask_stretches(Trial& trial, const LinkedHairs& hairs);
double ask_link_energy(Trial& trial, const LinkedHairs& hairs);
VectorXd ask_link_force(Trial& trial, const LinkedHairs& hairs, VectorXd f);
VectorXd ask_link_product(Trial& trial, const LinkedHairs& hairs, const VectorXd& dx, VectorXd df);
std::optional<StripContact> ask_touch(Trial& trial, const NearTriangle& near, double side);
double ask_strip_energy(Trial& trial, const Contacts& contacts);
VectorXd ask_strip_force(Trial& trial, const Contacts& contacts, VectorXd f);
VectorXd ask_strip_product(Trial& trial, const Contacts& contacts, const VectorXd& dx, VectorXd df);
VectorXd ask_friction(Trial& trial, const Contacts& contacts, double h, VectorXd v);

}  // namespace grader::h9
