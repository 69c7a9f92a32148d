// The methods that a study compares, and the problem's scene with one of them.
#pragma once

#include <string>
#include <vector>

#include "hair/truth/problem.h"

namespace hair {

// A method with its options, for a strand or a toy.
struct StudyMethod {
  std::string id;    // "h4-filtered-spd": in files
  std::string name;  // "H4, filtered": in plots
  Method method = Method::predictor_corrector;
  GeometricTerm geometric_term = GeometricTerm::filtered;
  Products bend_product = Products::definite;
  bool preconditioner = true;

  int order() const { return row_of(method).order; }  // the order of its time error, if known
  bool is_explicit() const { return row_of(method).is_explicit; }
};

// The methods that fit the problem: all of them for a strand, those that a toy's parts allow, except methods
// that call an `absent` exercise. H4 appears with each option of its Jacobian that makes a difference here,
// and with Newton's method to convergence. Implicit methods of strands appear once more without the
// preconditioner ("-plain"), but for those with exact bending.
std::vector<StudyMethod> methods_for(const Problem& problem, const std::vector<std::string>& absent = {});

// The description with the method and the options of its products.
Description with_options(Description hair, const StudyMethod& method);

// The problem's scene with this method and steps_per_frame steps for each frame.
Scene with_method(const Problem& problem, const StudyMethod& method, int steps_per_frame);

}  // namespace hair
