// STAFF ONLY. Serves H5. Each request: function, strand, tolerance, most iterations, then by function:
//   0 relax_lengths, 1 correct_lengths  x     -> x, report
//   2 correct_velocities                x, v  -> v, x, report
// A report is iterations, error, converged.
#include "grader/wire/strand_message.h"
#include "grader/worker/guarded_vectors.h"
#include "hair/length_correction.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const int function = session.request.get<int>();
  const hair::Strand strand = grader::get_strand(session.request);
  const double tolerance = session.request.get<double>();
  const int most = session.request.get<int>(), size = 3 * strand.count();
  grader::GuardedVector x(session.request.get_doubles(size));
  grader::GuardedScratch scratch(size, hair::kCorrectionScratch);

  hair::CorrectionReport report;
  if (function == 0) {
    report = hair::relax_lengths(strand, tolerance, most, x.view());
    session.reply.put(x.values());
  } else if (function == 1) {
    report = session.counted(
        [&] { return hair::correct_lengths(strand, tolerance, most, x.view(), scratch.view()); });
    session.reply.put(x.values());
  } else {
    grader::GuardedVector v(session.request.get_doubles(size));
    report = session.counted([&] {
      return hair::correct_velocities(strand, x.view(), tolerance, most, v.view(), scratch.view());
    });
    session.reply.put(v.values()).put(x.values());
  }
  session.reply.put(report.iterations).put(report.error).put(report.converged);
}
