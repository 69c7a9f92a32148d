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
  std::vector<Validation> all = {
      {"published-numbers",
       "Numbers that the rest is compared with, as computed here, beside what is printed",
       {},
       published_numbers}};
  for (const ChainMethod* method : {&chain_by_h6(), &chain_by_rods()})
    for (const auto& make : {pendulum_period, chain_oscillations}) all.push_back(make(*method));
  all.push_back({"elastica",
                 "Hair that is clamped level bends under its own weight like the elastica",
                 {"H1", "H2"},
                 hair_at_rest});
  all.push_back({"beam-frequencies",
                 "Frequencies of hair that is clamped and weighs nothing",
                 {"H1", "H2"},
                 beam_frequencies});
  all.push_back({"buckling", "The height at which hair that stands gets soft", {"H1", "H2"}, buckling});
  for (Validation& one : beam_swings()) all.push_back(std::move(one));
  all.push_back({"curl-gives-way", "A hanging curl leaves its plane: super-helices", {"H8"}, curl_gives_way});
  std::erase_if(all, [&](const Validation& one) { return calls_absent(one.exercises, absent); });
  return all;
}

}  // namespace hair
