#include "hair/validate/bending_validations.h"

namespace hair {

std::vector<Validation> bending_validations() {
  return {heavy_elastica(), hair_at_rest()};
}

}  // namespace hair
