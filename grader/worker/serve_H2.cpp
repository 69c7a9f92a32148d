// STAFF ONLY. Serves H2; see strand_call.h.
#include "hair/angular_springs.h"

#include "grader/worker/strand_call.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  grader::StrandCall call(session);
  const auto x = call.vector(call.x), dx = call.vector(call.dx);
  auto result = call.vector(call.result);
  switch (call.function) {
    case 0:
      session.reply.put(hair::bend_energy(call.strand, x));
      return;
    case 1:
      hair::add_bend_force(call.strand, x, result);
      break;
    case 2:
      hair::add_bend_product(call.strand, x, dx, result);
      break;
    case 3:
      hair::add_bend_product_spd(call.strand, x, dx, result);
      break;
  }
  session.reply.put(call.result.values());
}
