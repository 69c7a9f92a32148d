// STAFF ONLY. H5: its categories. Equal masses, segments of about 1 m and a root that is too heavy to move keep from most of them what
// is asked in others: by what masses particles move, in what unit an error is, whether the root moves.
#include "reference/H5/cases.h"

namespace grader::h5 {

Cases cases() {
  return {{"Relaxation", relaxation}, {"Lengths", lengths},       {"Impulses", impulses},
          {"Velocities", velocities}, {"Masses", masses},         {"Root", root},
          {"Report", report},         {"Iterations", iterations}, {"Degenerate", degenerate},
          {"FarRoot", far_root},      {"Units", units},           {"LongStrands", long_strands}};
}

}  // namespace grader::h5
