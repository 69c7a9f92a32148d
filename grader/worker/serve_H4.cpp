// STAFF ONLY. Serves H4, its forces held by the suite. Each request: function, particles, state, then by function:
//   0 implicit_matrix  a, b, vector, junk     -> product, vector; product again
//   1 solve_implicit   a, b, tolerance, junk  -> dv, report
//   2 implicit_euler   h, tolerance           -> x, v, report
// and at the end of each reply the products that were to be added to their own input. `junk` is what the result's
// buffer holds before; a report is as in report_message.h.
#include "grader/wire/particles_message.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"
#include "grader/worker/guarded_vectors.h"
#include "grader/worker/served_force.h"
#include "particles/implicit_euler.h"

namespace {

using grader::GuardedVector;
using grader::Session;

}  // namespace

extern "C" __attribute__((visibility("default"))) void serve(Session& session) {
  const int function = session.request.get<int>();
  const particles::Particles particles = grader::get_particles(session.request);
  const int n = particles.count();
  particles::State state = grader::get_state(session.request, n);
  const grader::ServedForce force(session, n);
  grader::GuardedScratch scratch(3 * n, particles::kImplicitScratch);

  if (function == 0) {
    const double a = session.request.get<double>(), b = session.request.get<double>();
    GuardedVector x(session.request.get_doubles(state.x.size()));
    const std::vector<double> junk = session.request.get_doubles(state.x.size());
    GuardedVector first(junk), second(junk);
    const std::unique_ptr<implicitMatrix> matrix = particles::implicit_matrix(force, particles, state, a, b);
    for (GuardedVector* product : {&first, &second})
      session.counted([&] { matrix->matVecMult(x.view().data(), product->view().data()); });
    session.reply.put(first.values()).put(second.values());
  } else if (function == 1) {
    const double a = session.request.get<double>(), b = session.request.get<double>();
    const double tolerance = session.request.get<double>();
    GuardedVector dv(session.request.get_doubles(state.x.size()));
    const particles::SolveReport report = session.counted([&] {
      return particles::solve_implicit(force, particles, state, a, b, tolerance, dv.view(), scratch.view());
    });
    session.reply.put(dv.values());
    grader::put(session.reply, report);
  } else {
    const double h = session.request.get<double>(), tolerance = session.request.get<double>();
    const particles::SolveReport report = session.counted(
        [&] { return particles::implicit_euler(force, particles, h, tolerance, state, scratch.view()); });
    grader::put(session.reply, state.x);
    grader::put(session.reply, state.v);
    grader::put(session.reply, report);
  }
}
