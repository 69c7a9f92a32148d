// X1: air drag. The contract is in particles/air_drag.h, the text in assignment/X1-air-drag.md.

#include "particles/air_drag.h"

#include "solver/not_implemented.h"

namespace particles {

void add_air_drag(double /*coefficient*/, Input /*wind*/, Input /*v*/, Output /*f*/) {
  throw NotImplemented("X1 add_air_drag");
}

}  // namespace particles
