// STAFF ONLY. H6, asked of the student's worker: the request of grader/worker/serve_H6.cpp. The forces stay here.
#include <limits>

#include "grader/play/asking.h"
#include "grader/play/force_server.h"
#include "grader/wire/particles_message.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"
#include "hair/predictor_corrector.h"

namespace hair {

StepReport predictor_corrector(const particles::Force& force, const particles::Particles& particles,
                               const Strand& strand, double h, double tolerance, particles::State& state,
                               Scratch) {
  grader::MessageWriter request;
  grader::put(request, strand);
  grader::put(request, particles);
  grader::put(request, state);
  request.put(h).put(tolerance);
  // No limit here: player.cpp has one.
  grader::ForceServer server(force, particles.count(), std::numeric_limits<int>::max());
  grader::MessageReader reply = grader::ask_student(request, std::ref(server));
  state = grader::get_state(reply, particles.count());
  StepReport report;
  report.filter = grader::get_solve_report(reply);
  report.correction = grader::get_correction_report(reply);
  report.second_filter = grader::get_solve_report(reply);
  if (grader::overlapped(reply)) state.v.setConstant(grader::kNoNumber);
  return report;
}

}  // namespace hair
