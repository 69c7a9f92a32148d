#include "hair/lab/validate/validations.h"

#include <algorithm>
#include <utility>

#include "hair/lab/validate/bending_validations.h"
#include "solver/course.h"

namespace hair {

namespace {

bool has_all(const std::vector<std::string>& exercises) {
  return std::all_of(exercises.begin(), exercises.end(), [](const std::string& id) { return in_course(id); });
}

}  // namespace

std::vector<Validation> all_validations() {
  std::vector<Validation> validations = {published_numbers()};
  for (const ChainMethod* method : {&chain_by_h6(), &chain_by_rods()}) {
    validations.push_back(pendulum_period(*method));
    validations.push_back(chain_oscillations(*method));
    validations.push_back(double_pendulums(*method));
  }
  for (Validation& one : bending_validations()) validations.push_back(std::move(one));
  if constexpr (in_course("H8")) validations.push_back(curl_gives_way());
  std::erase_if(validations, [](const Validation& one) { return !has_all(one.exercises); });
  return validations;
}

}  // namespace hair
