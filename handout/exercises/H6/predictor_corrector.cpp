// H6: the lecture's predictor-corrector. The contract is in hair/predictor_corrector.h, the text in
// exercises/H6/text.md.

#include "hair/predictor_corrector.h"

#include "solver/not_implemented.h"

namespace hair {

StepReport predictor_corrector(const particles::Force& /*force*/, const particles::Particles& /*particles*/,
                               const Strand& /*strand*/, double /*h*/, double /*tolerance*/,
                               particles::State& /*state*/, Scratch /*scratch*/) {
  throw NotImplemented("H6 predictor_corrector");
}

}  // namespace hair
