// The validations, and the functions that run them.
#pragma once

#include "hair/lab/validate/chain_methods.h"

namespace hair {

// They keep a reference to the method. In pendulum_period.cpp, then chain_oscillations.cpp.
Validation pendulum_period(const ChainMethod& method);
Validation chain_oscillations(const ChainMethod& method);

std::vector<Validation> beam_swings();  // by Runge-Kutta 4, H4 and H6

// Others, each in its own file.
ValidationResult published_numbers(const ValidationSettings&);
ValidationResult hair_at_rest(const ValidationSettings& settings);
ValidationResult beam_frequencies(const ValidationSettings& settings);
ValidationResult buckling(const ValidationSettings& settings);
ValidationResult curl_gives_way(const ValidationSettings& settings);

}  // namespace hair
