#include "hair/lab/validate/bending_validations.h"

namespace hair {

std::vector<Validation> bending_validations() {
  std::vector<Validation> all = {heavy_elastica(), hair_at_rest(), beam_frequencies(),
                                 end_moment(),     buckling(),     beam_swing(Method::runge_kutta_4)};
  for (const Method method : {Method::implicit_euler, Method::predictor_corrector})
    for (const auto& make : {beam_swing, elastica_in_motion, buckling_in_motion, curl_at_rest})
      all.push_back(make(method));
  return all;
}

}  // namespace hair
