#include <set>

#include "hair/scene/scene.h"

namespace hair {

namespace {

void add_strands(const Description& hair, std::set<std::string>& called) {
  switch (hair.method) {
    case Method::predictor_corrector:
      called.insert({"S1", "H4", "H5", "H6"});
      break;
    case Method::implicit_euler:
    case Method::newton_euler:
      called.insert({"S1", "H4"});
      break;
    default:
      called.insert("P1");
  }
  for (const StrandStart& start : hair.strands) {
    if (start.strand.stretch_rigidity > 0) called.insert("H1");
    if (start.strand.bend_rigidity > 0 && start.rest_curvature.size() == 0) called.insert("H2");
    if (start.strand.skip_rigidity > 0) called.insert("H3");
  }
}

void add_toy(const Toy& toy, std::set<std::string>& called) {
  if (toy.method == ToyMethod::implicit_euler) {
    called.insert({"S1", "H4"});
  } else {
    called.insert("P1");
  }
  if (toy.constraints.rows() > 0) called.insert({"S1", "P2"});
}

}  // namespace

std::vector<std::string> exercises_of(const Scene& scene) {
  std::set<std::string> called;
  if (!scene.hair.strands.empty()) add_strands(scene.hair, called);
  for (const Toy& toy : scene.toys) add_toy(toy, called);
  std::vector<std::string> ordered;
  for (const char* id : {"S1", "P1", "P2", "H1", "H2", "H3", "H4", "H5", "H6"})
    if (called.count(id) > 0) ordered.emplace_back(id);
  return ordered;
}

}  // namespace hair
