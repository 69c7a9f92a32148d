#include "hair/simulation/models.h"

namespace hair {

const ModelRow* find_model(std::string_view id) {
  for (const ModelRow& row : models())
    if (row.id == id) return &row;
  return nullptr;
}

}  // namespace hair
