#include "hair/truth/model_ode.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace hair {

namespace {

const OdeRow* row_of(const ModelRow& model) {
  for (const OdeRow& row : model_odes())
    if (std::string_view(row.model) == model.id) return &row;
  return nullptr;
}

}  // namespace

bool has_ode(const ModelRow& model) {
  return row_of(model) != nullptr;
}

std::unique_ptr<Ode> model_ode(const Problem& problem) {
  const ModelRow& model = *problem.scene.hair.modelled.at(0).model;
  const OdeRow* row = row_of(model);
  if (!row) throw std::invalid_argument(std::string("studies know no ") + model.id);
  return row->make(problem);
}

}  // namespace hair
