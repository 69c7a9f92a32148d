// Hostile bytes as a scene. An accepted scene is finite, can be assembled, and is the same when its JSON is
// written and read again, as the grader does with hidden scenes. Scenes here have few particles: more would
// take time, and test nothing else.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/fuzz/fuzz.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/scene_run.h"
#include "hair/scene/test_reading.h"

namespace {

using hair::Scene;
using Numbers = std::vector<double>;

constexpr long kMostParticlesTried = 1000;

hair::json::Reading reading() {
  hair::json::Reading reading;
  reading.most_particles = kMostParticlesTried;
  reading.groom = [](const hair::JsonValue& file) {
    file.text();
    return std::vector<Eigen::VectorXd>{(Eigen::VectorXd(6) << 0, 0, 0, 1, 0, 0).finished(),
                                        (Eigen::VectorXd(9) << 0, 1, 0, 0, 1, 1, 0, 1.5, 2).finished()};
  };
  return reading;
}

Scene read(const hair::JsonDocument& document) {
  return hair::json::scene_of(document, "a.json", reading());
}

void add(Numbers& all, const auto& vector) {
  all.insert(all.end(), vector.begin(), vector.end());
}

Numbers numbers_of(const hair::StrandStart& start) {
  const hair::Strand& strand = start.strand;
  Numbers all = {strand.stretch_rigidity, strand.bend_rigidity, strand.skip_rigidity,
                 static_cast<double>(strand.clamped)};
  for (const Eigen::VectorXd* vector :
       {&strand.mass, &strand.rest_length, &start.state.x, &start.state.v, &start.rest_curvature})
    add(all, *vector);
  add(all, strand.root_tangent);
  add(all, start.root_normal);
  return all;
}

Numbers numbers_of(const hair::Toy& toy) {
  Numbers all = {toy.drag, toy.constraints.stiffness, toy.constraints.damping};
  for (const Eigen::VectorXd* vector : {&toy.particles.mass, &toy.start.x, &toy.start.v}) add(all, *vector);
  add(all, toy.particles.pinned);
  for (const particles::Spring& spring : toy.springs)
    add(all, Numbers{1.0 * spring.i, 1.0 * spring.j, spring.stiffness, spring.rest_length, spring.damping});
  for (const particles::Rod& rod : toy.constraints.rods)
    add(all, Numbers{1.0 * rod.i, 1.0 * rod.j, rod.length});
  for (const particles::Wire& wire : toy.constraints.wires) {
    add(all, Numbers{1.0 * wire.i, wire.radius});
    add(all, wire.centre);
    add(all, wire.normal);
  }
  return all;
}

// All numbers that a motion depends on, except names and choices.
Numbers numbers_of(const Scene& scene) {
  Numbers all = {1.0 * scene.frames, scene.frames_per_second, 1.0 * scene.steps_per_frame,
                 scene.hair.step,    scene.hair.drag,         scene.hair.tolerance};
  add(all, scene.hair.gravity);
  add(all, scene.hair.wind);
  for (const hair::StrandStart& start : scene.hair.strands) add(all, numbers_of(start));
  for (const hair::Toy& toy : scene.toys) add(all, numbers_of(toy));
  for (const hair::Rider& rider : scene.riders) {
    for (const hair::Key& key : rider.motion.keys) {
      all.push_back(key.time);
      add(all, key.pose.position);
      add(all, key.pose.rotation.coeffs());
    }
    add(all, rider.strands);
    add(all, rider.obstacles);
  }
  for (const hair::Obstacle& obstacle : scene.hair.obstacles)
    add(all, hair::surface_at(obstacle, {1, 2, 3}).normal);
  return all;
}

void check(const Scene& scene, const hair::JsonDocument& document) {
  const Numbers numbers = numbers_of(scene);
  fuzz::expect(
      std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }),
      "a scene's numbers are finite");
  fuzz::expect(numbers_of(read(hair::parse_document(document->dump(), "b.json"))) == numbers,
               "a scene that is written is read as it was");
  const hair::SceneRun scene_run(scene);
  fuzz::expect(scene_run.state().x.allFinite(), "a scene begins somewhere");
}

}  // namespace

void fuzz::try_input(std::string_view bytes) {
  try {
    const hair::JsonDocument document = hair::parse_document(std::string(bytes), "a.json");
    check(read(document), document);
  } catch (const hair::BadInput& error) {
    expect_readable(error.what());
    expect(std::string_view(error.what()).starts_with("a.json: "), "a message begins with the file's name");
  }
}

// A particle is about 30 numbers, in the scene, in the scene that is read again, and in the assembled one. A
// value of JSON takes at least two bytes, and two hundred in a list of values with positions; two such lists
// exist at once, and grow by doubling.
std::size_t fuzz::most_memory(std::size_t input) {
  return 4'000'000 + 800 * input;
}

std::vector<std::string> fuzz::seeds() {
  std::vector<std::string> all = {reference_tests::small_scene()};
  for (const auto& entry : std::filesystem::directory_iterator(HAIR_SCENES)) {
    if (entry.path().extension() == ".json") all.push_back(hair::bytes_of(entry.path()));
  }
  all.emplace_back(
      R"({"shows": "a groom", "frames": 2, "hair": [{"groom": {"file": "a.hair", "scale": 0.5, "every": 2,)"
      R"( "move": [1, 0, 0]}, "clamped": true}]})");
  return all;
}
