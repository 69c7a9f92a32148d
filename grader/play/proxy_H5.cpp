// STAFF ONLY. H5, asked of the student's worker: the requests of grader/worker/serve_H5.cpp.
#include "grader/play/asking.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"
#include "hair/length_correction.h"

namespace hair {
namespace {

constexpr int kRelax = 0, kCorrect = 1, kVelocities = 2;

grader::MessageWriter request_of(int function, const Strand& strand, double tolerance, int most, Input x) {
  grader::MessageWriter request;
  request.put(function);
  grader::put(request, strand);
  request.put(tolerance).put(most);
  grader::put(request, Eigen::VectorXd(x));
  return request;
}

CorrectionReport report_of(grader::MessageReader& reply) {
  const CorrectionReport report = grader::get_correction_report(reply);
  reply.expect_end();
  return report;
}

CorrectionReport ask_for_lengths(int function, const Strand& strand, double tolerance, int most, Output& x) {
  grader::MessageReader reply = grader::ask_student(request_of(function, strand, tolerance, most, x));
  x = grader::get_vector(reply, x.size());
  return report_of(reply);
}

}  // namespace

CorrectionReport relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x) {
  return ask_for_lengths(kRelax, strand, tolerance, most_sweeps, x);
}

CorrectionReport correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                 Scratch) {
  return ask_for_lengths(kCorrect, strand, tolerance, most_iterations, x);
}

CorrectionReport correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                    Output v, Scratch) {
  grader::MessageWriter request = request_of(kVelocities, strand, tolerance, most_sweeps, x);
  grader::put(request, v);
  grader::MessageReader reply = grader::ask_student(request);
  v = grader::get_vector(reply, v.size());
  grader::get_vector(reply, x.size());  // x after it, which is const here
  return report_of(reply);
}

}  // namespace hair
