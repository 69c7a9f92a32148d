#include "hair/lab/validate/validations.h"

#include <utility>

#include "hair/course/course.h"
#include "hair/lab/validate/bending_validations.h"

namespace hair {

std::vector<Validation> all_validations(const std::vector<std::string>& absent) {
  std::vector<Validation> validations = {published_numbers()};
  for (const ChainMethod* method : {&chain_by_h6(), &chain_by_rods()}) {
    validations.push_back(pendulum_period(*method));
    validations.push_back(chain_oscillations(*method));
    validations.push_back(double_pendulums(*method));
  }
  for (Validation& one : bending_validations()) validations.push_back(std::move(one));
  validations.push_back(curl_gives_way());
  std::erase_if(validations, [&](const Validation& one) { return calls_absent(one.exercises, absent); });
  return validations;
}

}  // namespace hair
