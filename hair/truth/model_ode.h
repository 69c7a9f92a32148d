// The equations of motion of strands that their models divide into elements, for the models that have such
// equations.
#pragma once

#include <memory>
#include <span>

#include "hair/simulation/models.h"
#include "hair/truth/ode.h"
#include "hair/truth/problem.h"

namespace hair {

struct OdeRow {
  const char* model;  // ModelRow::id
  std::unique_ptr<Ode> (*make)(const Problem& problem);
};

// The rows of all files <model>_ode.cpp in this folder: each defines the function <model>_ode, a row's
// `make`.
std::span<const OdeRow> model_odes();

bool has_ode(const ModelRow& model);

// Makes the equations of a modelled strand. Throws std::invalid_argument if its model has none.
std::unique_ptr<Ode> model_ode(const Problem& problem);

}  // namespace hair
