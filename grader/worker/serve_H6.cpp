// STAFF ONLY. Serves H6, its forces held by the suite. Request: strand, particles, state, h, tolerance. Reply: x, v,
// the report of step 1, of step 3, of step 5, products that were to be added to their own input.
#include "grader/wire/particles_message.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"
#include "grader/worker/guarded_vectors.h"
#include "grader/worker/served_force.h"
#include "hair/predictor_corrector.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const hair::Strand strand = grader::get_strand(session.request);
  const particles::Particles particles = grader::get_particles(session.request);
  const int n = particles.count();
  particles::State state = grader::get_state(session.request, n);
  const double h = session.request.get<double>(), tolerance = session.request.get<double>();

  const grader::ServedForce force(session, n);
  grader::GuardedScratch scratch(3 * n, hair::kPredictorCorrectorScratch);
  const hair::StepReport report = session.counted([&] {
    return hair::predictor_corrector(force, particles, strand, h, tolerance, state, scratch.view());
  });

  grader::put(session.reply, state.x);
  grader::put(session.reply, state.v);
  grader::put(session.reply, report.filter);
  grader::put(session.reply, report.correction);
  grader::put(session.reply, report.second_filter);
}
