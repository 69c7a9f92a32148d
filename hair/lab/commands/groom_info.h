// A groom's measures as text.
#pragma once

#include <string>

#include "hair/head/groom_measures.h"

namespace hair {

std::string in_groups(long number);                                        // "10,000"
std::string counted_with_groups(long count, const std::string& singular);  // "10,000 strands"
std::string counts_of(const Groom& groom);                                 // "2 strands, 5 points"

// Some lines; the last one names oddities.
std::string groom_info(const std::string& name, const Groom& groom, const GroomMeasures& measures);

}  // namespace hair
