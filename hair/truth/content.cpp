#include "hair/truth/content.h"

#include "hair/io/digest.h"

namespace hair {

namespace {

void add(Digest& digest, const StrandStart& start) {
  const Strand& strand = start.strand;
  digest.add(strand.mass).add(strand.rest_length);
  digest.add(strand.stretch_rigidity).add(strand.bend_rigidity).add(strand.skip_rigidity);
  digest.add(strand.clamped).add(strand.root_tangent);
  digest.add(start.state.x).add(start.state.v).add(start.rest_curvature).add(start.root_normal);
}

void add(Digest& digest, const Motion& motion) {
  digest.add(static_cast<int>(motion.keys.size()));
  for (const Key& key : motion.keys)
    digest.add(key.time).add(key.pose.position).add(key.pose.rotation.coeffs());
}

void add(Digest& digest, const Toy& toy) {
  digest.add(toy.particles.mass).add(toy.start.x).add(toy.start.v);
  for (const char pinned : toy.particles.pinned) digest.add(pinned != 0);
  digest.add(static_cast<int>(toy.springs.size()));
  for (const particles::Spring& spring : toy.springs)
    digest.add(spring.i).add(spring.j).add(spring.stiffness).add(spring.rest_length).add(spring.damping);
  digest.add(static_cast<int>(toy.constraints.rods.size()));
  for (const particles::Rod& rod : toy.constraints.rods) digest.add(rod.i).add(rod.j).add(rod.length);
  digest.add(static_cast<int>(toy.constraints.wires.size()));
  for (const particles::Wire& wire : toy.constraints.wires)
    digest.add(wire.i).add(wire.centre).add(wire.normal).add(wire.radius);
  digest.add(toy.constraints.stiffness).add(toy.constraints.damping);
  digest.add(toy.gravity).add(toy.drag).add(toy.wind);
}

}  // namespace

std::string content_of(const Problem& problem) {
  const Scene& scene = problem.scene;
  Digest digest;
  digest.add(problem.duration).add(scene.frames);
  digest.add(scene.hair.gravity).add(scene.hair.drag).add(scene.hair.wind);
  digest.add(static_cast<int>(scene.hair.strands.size()));
  for (const StrandStart& start : scene.hair.strands) add(digest, start);
  digest.add(static_cast<int>(scene.riders.size()));
  for (const Rider& rider : scene.riders) add(digest, rider.motion);
  digest.add(static_cast<int>(scene.toys.size()));
  for (const Toy& toy : scene.toys) add(digest, toy);
  return digest.text();
}

}  // namespace hair
