#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

using particles::Rod, particles::Spring, particles::Wire;

void read_particles(const JsonValue& list, Reading& reading, Toy& toy) {
  const std::vector<JsonValue> items = list.items();
  if (items.empty()) list.fail("has no particles; give one at least");
  const auto n = static_cast<Eigen::Index>(items.size());
  reading.expect(list, 1, n);
  toy.particles.mass.resize(n);
  toy.particles.pinned.assign(items.size(), 0);
  toy.start = {Eigen::VectorXd(3 * n), Eigen::VectorXd(3 * n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const JsonValue& item = items[static_cast<std::size_t>(i)];
    item.check_keys({"position", "mass"}, {"velocity", "pinned"});
    toy.particles.mass[i] = mass(item["mass"]);
    toy.particles.pinned[static_cast<std::size_t>(i)] = boolean_or(item, "pinned", false);
    toy.start.x.segment<3>(3 * i) = vector(item["position"], kFar);
    toy.start.v.segment<3>(3 * i) = vector_or(item, "velocity", Vector3d::Zero(), kFast);
  }
}

int read_particle(const JsonValue& value, const Toy& toy) {
  return static_cast<int>(value.whole_number(0, toy.particles.count() - 1));
}

struct Pair {
  int i, j;
  double distance;  // m, at the start
};

Pair read_pair(const JsonValue& value, const Toy& toy) {
  const std::vector<JsonValue> ends = value.items();
  if (ends.size() != 2) value.fail("does not have two particles; write [0, 1]");
  const int i = read_particle(ends[0], toy), j = read_particle(ends[1], toy);
  if (i == j) value.fail("is twice the same particle; give two");
  return {i, j, (toy.start.x.segment<3>(3 * i) - toy.start.x.segment<3>(3 * j)).norm()};
}

void read_springs(const JsonValue& list, Toy& toy) {
  for (const JsonValue& item : list.items()) {
    item.check_keys({"between", "stiffness"}, {"rest_length", "damping"});
    const Pair pair = read_pair(item["between"], toy);
    toy.springs.push_back(Spring{pair.i, pair.j, item["stiffness"].number(0, 1e12),
                                 number_or(item, "rest_length", pair.distance, 0, kLongest),
                                 number_or(item, "damping", 0, 0, 1e9)});
  }
}

void read_rods(const JsonValue& list, Toy& toy) {
  for (const JsonValue& item : list.items()) {
    item.check_keys({"between"}, {"length"});
    const Pair pair = read_pair(item["between"], toy);
    toy.constraints.rods.push_back(
        Rod{pair.i, pair.j, number_or(item, "length", pair.distance, 0, kLongest)});
  }
}

void read_wires(const JsonValue& list, Toy& toy) {
  for (const JsonValue& item : list.items()) {
    item.check_keys({"particle", "centre", "normal", "radius"});
    toy.constraints.wires.push_back(Wire{read_particle(item["particle"], toy), vector(item["centre"], kFar),
                                         direction(item["normal"]), length(item["radius"])});
  }
}

Toy read_toy(const JsonValue& item, Reading& reading) {
  Toy toy;
  if (item.has("cloth")) {
    item.check_keys({"cloth"}, {"method", "drag"});
    toy = read_cloth(item["cloth"], reading);
  } else {
    item.check_keys({"particles"}, {"method", "springs", "rods", "wires", "feedback", "drag"});
    read_particles(item["particles"], reading, toy);
  }
  toy.gravity = reading.scene.hair.gravity;
  toy.wind = reading.scene.hair.wind;
  if (item.has("method")) {
    std::vector<std::string_view> ids;
    std::vector<ToyMethod> toy_methods;
    for (const MethodRow& row : methods()) {
      if (!row.toy) continue;
      ids.emplace_back(row.id);
      toy_methods.push_back(*row.toy);
    }
    toy.method = toy_methods[item["method"].word(ids)];
  }
  toy.drag = number_or(item, "drag", 0, 0, 1e6);
  if (item.has("springs")) read_springs(item["springs"], toy);
  if (item.has("rods")) read_rods(item["rods"], toy);
  if (item.has("wires")) read_wires(item["wires"], toy);
  if (item.has("feedback")) {
    const JsonValue feedback = item["feedback"];
    feedback.check_keys({"stiffness", "damping"});
    if (toy.constraints.rows() == 0) feedback.fail("there are no rods and no wires to hold; leave it out");
    toy.constraints.stiffness = feedback["stiffness"].number(0, 1e12);
    toy.constraints.damping = feedback["damping"].number(0, 1e9);
  }
  if (toy.method == ToyMethod::implicit_euler && toy.constraints.rows() > 0)
    item["method"].fail("rods and wires need an explicit method");
  return toy;
}

}  // namespace

void read_toys(const JsonValue& list, Reading& reading) {
  for (const JsonValue& item : list.items()) reading.scene.toys.push_back(read_toy(item, reading));
}

}  // namespace hair::json
