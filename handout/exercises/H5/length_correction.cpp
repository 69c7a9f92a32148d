// H5: the non-linear post correction. The contract is in hair/length_correction.h, the text in
// exercises/H5/text.md.

#include "hair/length_correction.h"

#include "solver/not_implemented.h"

namespace hair {

CorrectionReport relax_lengths(const Strand& /*strand*/, double /*tolerance*/, int /*most_sweeps*/,
                               Output /*x*/) {
  throw NotImplemented("H5 relax_lengths");
}

CorrectionReport correct_lengths(const Strand& /*strand*/, double /*tolerance*/, int /*most_iterations*/,
                                 Output /*x*/, Scratch /*scratch*/) {
  throw NotImplemented("H5 correct_lengths");
}

CorrectionReport correct_velocities(const Strand& /*strand*/, Input /*x*/, double /*tolerance*/,
                                    int /*most_sweeps*/, Output /*v*/, Scratch /*scratch*/) {
  throw NotImplemented("H5 correct_velocities");
}

}  // namespace hair
