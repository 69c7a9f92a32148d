#include "hair/truth/problem.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <variant>

#include "hair/io/files/bad_input.h"
#include "hair/simulation/models.h"
#include "hair/truth/model_ode.h"
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

bool is_straight(const StrandStart& strand) {
  return strand.rest_curvature.size() == 0;
}
bool is_straight(const ModelledStrand& strand) {
  return std::holds_alternative<Straight>(strand.spec.form);
}

int segments_of(const StrandStart& strand) {
  return strand.strand.segments();
}
int segments_of(const ModelledStrand& strand) {
  return strand.spec.elements;
}

void divide(StrandStart& strand, int segments) {
  strand = divide_anew(strand, segments);
}
void divide(ModelledStrand& strand, int segments) {
  strand.spec.elements = segments;
}

// The strand with the requested number of segments.
template <typename Any>
Any chosen(const Scene& scene, Any strand, const ProblemSettings& settings) {
  if (!settings.segments) return strand;
  if (!is_straight(strand))
    throw BadInput(scene.name + ": strand " + std::to_string(settings.strand) +
                   " rests curved and can't be divided anew; study it with the segments that it has");
  if (*settings.segments != segments_of(strand)) divide(strand, *settings.segments);
  return strand;
}

// Adds the studied strand as the only one of `hair`.
void add_strand(const Scene& scene, const ProblemSettings& settings, Description& hair) {
  const std::vector<StrandStart>& strands = scene.hair.strands;
  const std::vector<ModelledStrand>& modelled = scene.hair.modelled;
  require_part(scene, "strand", settings.strand, strands.size() + modelled.size());
  if (!scene.hair.obstacles.empty())
    throw BadInput(
        scene.name +
        ": hair that falls on obstacles can't be studied: a collision is no smooth motion, and no method "
        "has an order there; study a scene without \"obstacles\"");
  const auto index = static_cast<std::size_t>(settings.strand);
  if (index < strands.size()) {
    hair.strands = {chosen(scene, strands[index], settings)};
    return;
  }
  hair.modelled = {chosen(scene, modelled[index - strands.size()], settings)};
  const ModelRow& model = *hair.modelled[0].model;
  if (!has_ode(model))
    throw BadInput(scene.name + ": studies know no " + model.id +
                   "; study a scene whose hair is of another model");
  for (const MethodRow& row : methods())
    if (model.moves_by(row)) hair.method = row.method();
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
  const auto& [strands, modelled] = std::tie(scene.hair.strands, scene.hair.modelled);
  if (strand < 0) return {};
  const auto find = [](const auto& one) {
    return is_straight(one) ? std::optional(segments_of(one)) : std::nullopt;
  };
  const auto index = static_cast<std::size_t>(strand);
  if (index < strands.size()) return find(strands[index]);
  if (index - strands.size() < modelled.size()) return find(modelled[index - strands.size()]);
  return {};
}

std::unique_ptr<Body> modelled_body(const Problem& problem) {
  const ModelledStrand& strand = *problem.modelled();
  return strand.model->make(strand.spec, problem.scene.hair);
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
    add_strand(scene, settings, one.hair);
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

}  // namespace hair
