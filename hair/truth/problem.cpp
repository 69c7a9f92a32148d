#include "hair/truth/problem.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/digest.h"
#include "hair/simulation/models.h"
#include "particles/require.h"

namespace hair {

namespace {

// The point after `distance` metres along a polyline with the segments `lengths`.
Vector3d point_along(const Eigen::VectorXd& x, const Eigen::VectorXd& rest_lengths, double distance) {
  int i = 0;
  const int last = static_cast<int>(rest_lengths.size()) - 1;
  while (i < last && distance > rest_lengths[i]) distance -= rest_lengths[i++];
  const double part = std::min(1.0, distance / rest_lengths[i]);
  return (1 - part) * x.segment<3>(3 * i) + part * x.segment<3>(3 * (i + 1));
}

void require_part(const Scene& scene, const char* what, int part, std::size_t count) {
  if (part < 0 || static_cast<std::size_t>(part) >= count)
    throw BadInput(scene.name + ": there is no " + what + " " + std::to_string(part) + "; it has " +
                   (count == 0 ? "none" : what + ("s 0 to " + std::to_string(count - 1))));
}

// The strand that is studied, with as many segments as were asked for.
StrandStart chosen(const Scene& scene, const ProblemSettings& settings) {
  const std::vector<StrandStart>& strands = scene.hair.strands;
  if (strands.empty())
    throw BadInput(scene.name + ": studies know no " + scene.hair.modelled.at(0).model->id +
                   "; study a scene with hair of masses and springs");
  require_part(scene, "strand", settings.strand, strands.size());
  if (!scene.hair.obstacles.empty())
    throw BadInput(
        scene.name +
        ": hair that falls on obstacles can't be studied: a collision is no smooth motion, and no method "
        "has an order there; study a scene without \"obstacles\"");
  const StrandStart& strand = strands[static_cast<std::size_t>(settings.strand)];
  if (!settings.segments || *settings.segments == strand.strand.segments()) return strand;
  if (strand.rest_curvature.size() > 0)
    throw BadInput(scene.name + ": strand " + std::to_string(settings.strand) +
                   " rests curved and can't be divided anew; study it with the segments that it has");
  return divide_anew(strand, *settings.segments);
}

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

StrandStart divide_anew(const StrandStart& start, int segments) {
  particles::require_at_least("the segments of a strand", segments, 1);
  const Strand& old = start.strand;
  particles::require_at_least("the segments of a strand that is divided anew", old.segments(), 1);
  if (start.rest_curvature.size() > 0)
    throw std::invalid_argument("a strand that rests curved can't be divided anew");

  StrandStart result = start;
  Strand& strand = result.strand;
  const double length = old.rest_length.sum(), segment = length / segments;
  const double segment_mass = old.mass.sum() / segments;
  strand.rest_length = Eigen::VectorXd::Constant(segments, segment);
  strand.mass = Eigen::VectorXd::Constant(segments + 1, segment_mass);
  strand.mass[0] = strand.mass[segments] = segment_mass / 2;
  result.state.x.resize(3 * (segments + 1));
  result.state.v.resize(3 * (segments + 1));
  for (int i = 0; i <= segments; ++i) {
    result.state.x.segment<3>(3 * i) = point_along(start.state.x, old.rest_length, i * segment);
    result.state.v.segment<3>(3 * i) = point_along(start.state.v, old.rest_length, i * segment);
  }
  return result;
}

std::optional<int> segments_to_divide(const Scene& scene, int strand) {
  const std::vector<StrandStart>& strands = scene.hair.strands;
  if (strand < 0 || static_cast<std::size_t>(strand) >= strands.size()) return {};
  const StrandStart& start = strands[static_cast<std::size_t>(strand)];
  return start.rest_curvature.size() > 0 ? std::nullopt : std::optional(start.strand.segments());
}

Problem make_problem(const Scene& scene, const ProblemSettings& settings) {
  Problem problem;
  Scene& one = problem.scene;
  one = scene;
  one.look.reset();
  one.hair.obstacles.clear();
  one.hair.strands.clear();
  one.hair.modelled.clear();
  one.riders.clear();
  one.toys.clear();
  if (has_strands(scene)) {
    one.hair.strands = {chosen(scene, settings)};
    for (const Rider& rider : scene.riders)
      if (std::find(rider.strands.begin(), rider.strands.end(), settings.strand) != rider.strands.end())
        one.riders.push_back({rider.motion, {0}, {}});
  } else {
    require_part(scene, "toy", settings.strand, scene.toys.size());
    one.toys = {scene.toys[settings.strand]};
  }
  const double played = scene.frames / scene.frames_per_second;
  problem.duration = settings.duration.value_or(std::min(played, kLongestStudy));
  if (!(problem.duration > 0) || !std::isfinite(problem.duration))
    throw BadInput(scene.name + ": it lasts " + std::to_string(problem.duration) +
                   " s; a study needs more than 0");
  one.frames = kMoments;
  one.frames_per_second = kMoments / problem.duration;
  one.steps_per_frame = 1;
  one.hair.step = problem.duration / kMoments;
  return problem;
}

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
