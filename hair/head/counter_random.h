// Random numbers that know where they stand: the number of a counter is a function of seed and counter alone, so that threads
// may ask in any order.
#pragma once

#include <cstdint>

namespace hair {

// From 0 up to 1, evenly. G. Steele, D. Lea and C. Flood, "Fast Splittable Pseudorandom Number Generators" (OOPSLA 2014),
// SplitMix: its state after `counter` + 1 steps, mixed.
inline double counter_uniform(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed + (counter + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53;
}

}  // namespace hair
