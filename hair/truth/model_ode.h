// The equations of motion of strands that their models divide into elements: of each model that has them here.
#pragma once

#include <memory>

#include "hair/simulation/models.h"
#include "hair/truth/ode.h"
#include "hair/truth/problem.h"

namespace hair {

bool has_ode(const ModelRow& model);

// Of a problem with a modelled strand. Throws std::invalid_argument if its model has none.
std::unique_ptr<Ode> model_ode(const Problem& problem);

// Of rigid links.
std::unique_ptr<Ode> links_ode(const Problem& problem);

}  // namespace hair
