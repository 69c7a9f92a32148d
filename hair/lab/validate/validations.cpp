#include "hair/lab/validate/validations.h"

#include <cmath>
#include <utility>

#include "hair/course/course.h"

namespace hair {

bool Check::holds() const {
  return std::isfinite(measured) && std::isfinite(expected) && std::abs(error()) <= tolerance;
}

void ValidationSettings::go_on() const {
  if (interrupted && *interrupted) throw Interrupted();
}

std::vector<Validation> all_validations(const std::vector<std::string>& absent) {
  std::vector<Validation> all = {published_numbers()};
  for (const ChainMethod* method : {&chain_by_h6(), &chain_by_rods()})
    for (const auto& make : {pendulum_period, chain_oscillations}) all.push_back(make(*method));
  for (const auto& make : {hair_at_rest, beam_frequencies, buckling}) all.push_back(make());
  for (const Method method : {Method::runge_kutta_4, Method::implicit_euler, Method::predictor_corrector})
    all.push_back(beam_swing(method));
  all.push_back(curl_gives_way());
  std::erase_if(all, [&](const Validation& one) { return calls_absent(one.exercises, absent); });
  return all;
}

}  // namespace hair
