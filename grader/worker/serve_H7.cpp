// STAFF ONLY. Serves H7. Each request: function, links, passes, then by function:
//   0 outward_velocities     rates  -> passes
//   1 inward_inertias        Q      -> passes
//   2 outward_accelerations  Q      -> passes, accelerations
#include "grader/wire/link_message.h"
#include "grader/worker/guarded_vectors.h"
#include "hair/rigid_links.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const int function = session.request.get<int>();
  int rates = 0;
  const std::vector<hair::Link> links = grader::get_links(session.request, rates);
  std::vector<hair::LinkPass> passes = grader::get_passes(session.request, links.size());
  grader::GuardedVector input(session.request.get_doubles(rates));
  const std::size_t count = passes.size();

  grader::GuardedScratch accelerations(rates, 1);
  session.counted([&] {
    if (function == 0)
      hair::outward_velocities(links, input.view(), passes);
    else if (function == 1)
      hair::inward_inertias(links, input.view(), passes);
    else
      hair::outward_accelerations(links, input.view(), passes, accelerations.view().col(0));
  });
  passes.resize(count);
  put(session.reply, passes);
  if (function == 2) session.reply.put(std::span<const double>(accelerations.view().data(), rates));
}
