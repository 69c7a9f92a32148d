#include "hair/truth/content.h"

#include <string_view>

#include "hair/io/files/digest.h"
#include "hair/simulation/models.h"

namespace hair {

namespace {

void add(Digest& digest, const StrandStart& start) {
  const Strand& strand = start.strand;
  digest.add(strand.mass).add(strand.rest_length);
  digest.add(strand.stretch_rigidity).add(strand.bend_rigidity).add(strand.skip_rigidity);
  digest.add(strand.clamped).add(strand.root_tangent);
  digest.add(start.state.x).add(start.state.v).add(start.rest_curvature).add(start.root_normal);
}

// Names every member, so that the compiler reports a new one.
void add(Digest& digest, const Fibre& fibre) {
  const auto& [material, stretch, bend, twist, skip, relaxation_time, joint_limit] = fibre;
  const auto& [radius, density, young_modulus, shear_modulus] = material;
  digest.add(radius).add(density).add(young_modulus).add(shear_modulus);
  digest.add(stretch).add(bend).add(twist).add(skip).add(relaxation_time);
  digest.add(joint_limit.has_value()).add(joint_limit.value_or(0));
}

void add(Digest& digest, const ModelledStrand& strand) {
  const auto& [fibre, form, length, elements, root, clamped, start, root_velocity] = strand.spec;
  digest.add(std::string_view(strand.model->id));
  add(digest, fibre);
  const RestShape shape = rest_shape(strand.spec);  // from form, length, elements and root
  digest.add(shape.x).add(shape.tangent).add(shape.normal);
  digest.add(static_cast<int>(form.index())).add(length).add(elements).add(root.position).add(clamped);
  const auto& [differently, direction, stretch, folded, spin] = start;
  digest.add(differently).add(direction).add(stretch).add(folded).add(spin);
  digest.add(root_velocity);
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
  digest.add(static_cast<int>(scene.hair.modelled.size()));
  for (const ModelledStrand& strand : scene.hair.modelled) add(digest, strand);
  digest.add(static_cast<int>(scene.riders.size()));
  for (const Rider& rider : scene.riders) add(digest, rider.motion);
  digest.add(static_cast<int>(scene.toys.size()));
  for (const Toy& toy : scene.toys) add(digest, toy);
  return digest.text();
}

}  // namespace hair
