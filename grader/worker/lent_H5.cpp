// STAFF ONLY. H5, lent by the suite.
#include "hair/length_correction.h"

#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"
#include "grader/worker/lent_objects.h"

namespace hair {
namespace {

// `changed` is what the function changes, x or v.
CorrectionReport correct(int function, const Strand& strand, double tolerance, int most, Input x,
                         particles::Output& changed) {
  const grader::Session::Uncounted ours(*lent_session);
  grader::MessageWriter call;
  call.put(function);
  grader::put(call, strand);
  call.put(tolerance).put(most);
  grader::put(call, Eigen::VectorXd(x));
  if (function == grader::kLentCorrectVelocities) grader::put(call, Eigen::VectorXd(changed));
  grader::MessageReader result = lent_session->call(call, grader::no_callback);
  changed = grader::get_vector(result, changed.size());
  return grader::get_correction_report(result);
}

}  // namespace

CorrectionReport relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x) {
  return correct(grader::kLentRelaxLengths, strand, tolerance, most_sweeps, x, x);
}

CorrectionReport correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                 Scratch scratch) {
  grader::spoil(scratch, kCorrectionScratch);
  return correct(grader::kLentCorrectLengths, strand, tolerance, most_iterations, x, x);
}

CorrectionReport correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                    Output v, Scratch scratch) {
  grader::spoil(scratch, kCorrectionScratch);
  return correct(grader::kLentCorrectVelocities, strand, tolerance, most_sweeps, x, v);
}

}  // namespace hair
