// STAFF ONLY. Cases of H4 that stand in files of their own.
#pragma once

#include "grader/suite/trial.h"

namespace grader::h4 {

void preconditioned(Trial& trial);

}  // namespace grader::h4
