#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

using particles::Rod, particles::Spring, particles::Wire;

struct ParticleText {
  Vector3d position;
  double mass;
  Vector3d velocity = Vector3d::Zero();
  bool pinned = false;
};

void keys_of(Keys& keys, ParticleText& particle) {
  keys.about("Counted from 0.");
  keys.vector("position", particle.position, {.unit = "m", .needed = true});
  keys.number("mass", particle.mass, {.unit = "kg", .needed = true, .least = 1e-15, .most = 1e6});
  keys.vector("velocity", particle.velocity, {.unit = "m/s"});
  keys.flag("pinned", particle.pinned, {}, "keeps its velocity, whatever force acts");
}

struct SpringText {
  std::optional<JsonValue> between;
  double stiffness;
  std::optional<double> rest_length;
  double damping = 0;
};

void keys_of(Keys& keys, SpringText& spring) {
  keys.any("between", spring.between, {.needed = true}, "two particles, as in [0, 1]");
  keys.number("stiffness", spring.stiffness, {.unit = "N/m", .needed = true, .least = 0, .most = 1e12});
  keys.number("rest_length", spring.rest_length,
              {.unit = "m", .least = 0, .most = kLongest, .otherwise = "as at the start"});
  keys.number("damping", spring.damping, {.unit = "N s/m", .least = 0, .most = 1e9}, "along the spring");
}

struct RodText {
  std::optional<JsonValue> between;
  std::optional<double> length;
};

void keys_of(Keys& keys, RodText& rod) {
  keys.any("between", rod.between, {.needed = true}, "two particles");
  keys.length("length", rod.length, {.otherwise = "as at the start"});
}

struct WireText {
  std::optional<JsonValue> particle;
  Vector3d centre, normal;
  double radius;
};

void keys_of(Keys& keys, WireText& wire) {
  keys.about("A circle that a particle slides along.");
  keys.any("particle", wire.particle, {.needed = true});
  keys.vector("centre", wire.centre, {.unit = "m", .needed = true});
  keys.direction("normal", wire.normal, {.needed = true}, "of the circle's plane");
  keys.length("radius", wire.radius, {.needed = true});
}

struct Feedback {
  double stiffness, damping;
};

void keys_of(Keys& keys, Feedback& feedback) {
  keys.number("stiffness", feedback.stiffness, {.unit = "1/s²", .needed = true, .least = 0, .most = 1e12});
  keys.number("damping", feedback.damping, {.unit = "1/s", .needed = true, .least = 0, .most = 1e9},
              "2 √stiffness is critical");
}

// The common keys of all toys.
struct ToyText {
  std::size_t method = 3;  // an index of the toys' methods: runge_kutta_4
  double drag = 0;
};

const std::vector<MethodRow>& toy_methods() {
  static const std::vector<MethodRow> rows = [] {
    std::vector<MethodRow> found;
    for (const MethodRow& row : methods())
      if (row.toy) found.push_back(row);
    return found;
  }();
  return rows;
}

void keys_of(Keys& keys, ToyText& toy) {
  keys.word("method", toy.method, words_of(toy_methods(), &MethodRow::id), {},
            "P1's or H4's; rods and wires need one of P1's");
  keys.number("drag", toy.drag, {.unit = "kg/s", .least = 0, .most = 1e6}, "of the air, for each particle");
}

struct ParticlesText {
  std::optional<JsonValue> particles, springs, rods, wires, feedback;
  ToyText toy;
};

void keys_of(Keys& keys, ParticlesText& text) {
  keys.about("Points with mass, and the springs, rods and wires that hold them together.");
  keys.list("particles", text.particles, {.needed = true, .objects = {object<ParticleText>()}});
  keys.list("springs", text.springs, {.objects = {object<SpringText>()}});
  keys.list("rods", text.rods, {.objects = {object<RodText>()}}, "held by P2's constraint forces");
  keys.list("wires", text.wires, {.objects = {object<WireText>()}}, "likewise");
  keys.any("feedback", text.feedback, {.otherwise = "none", .objects = {object<Feedback>()}},
           "what corrects errors of rods and wires");
  keys_of(keys, text.toy);
}

struct ClothToyText {
  std::optional<JsonValue> cloth;
  ToyText toy;
};

void keys_of(Keys& keys, ClothToyText& text) {
  keys.any("cloth", text.cloth, {.needed = true, .objects = {object<ClothText>()}});
  keys_of(keys, text.toy);
}

void read_particles(const JsonValue& list, Reading& reading, Toy& toy) {
  const std::vector<JsonValue> items = list.items();
  if (items.empty()) list.fail("has no particles; give one at least");
  const auto n = static_cast<Eigen::Index>(items.size());
  reading.expect(list, 1, n);
  toy.particles.mass.resize(n);
  toy.particles.pinned.assign(items.size(), 0);
  toy.start = {Eigen::VectorXd(3 * n), Eigen::VectorXd(3 * n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto particle = read<ParticleText>(items[static_cast<std::size_t>(i)]);
    toy.particles.mass[i] = particle.mass;
    toy.particles.pinned[static_cast<std::size_t>(i)] = particle.pinned;
    toy.start.x.segment<3>(3 * i) = particle.position;
    toy.start.v.segment<3>(3 * i) = particle.velocity;
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
    const auto text = read<SpringText>(item);
    const Pair pair = read_pair(*text.between, toy);
    toy.springs.push_back(
        Spring{pair.i, pair.j, text.stiffness, text.rest_length.value_or(pair.distance), text.damping});
  }
}

void read_rods(const JsonValue& list, Toy& toy) {
  for (const JsonValue& item : list.items()) {
    const auto text = read<RodText>(item);
    const Pair pair = read_pair(*text.between, toy);
    if (pair.distance < kShortest)
      text.between->fail("are two particles at one place, and a rod needs a direction; move one of them");
    toy.constraints.rods.push_back(Rod{pair.i, pair.j, text.length.value_or(pair.distance)});
  }
}

void read_wires(const JsonValue& list, Toy& toy) {
  for (const JsonValue& item : list.items()) {
    const auto text = read<WireText>(item);
    toy.constraints.wires.push_back(
        Wire{read_particle(*text.particle, toy), text.centre, text.normal, text.radius});
  }
}

Toy read_parts(const ParticlesText& text, Reading& reading) {
  Toy toy;
  read_particles(*text.particles, reading, toy);
  if (text.springs) read_springs(*text.springs, toy);
  if (text.rods) read_rods(*text.rods, toy);
  if (text.wires) read_wires(*text.wires, toy);
  if (text.feedback) {
    const auto feedback = read<Feedback>(*text.feedback);
    if (toy.constraints.rows() == 0)
      text.feedback->fail("there are no rods and no wires to hold; leave it out");
    toy.constraints.stiffness = feedback.stiffness;
    toy.constraints.damping = feedback.damping;
  }
  return toy;
}

Toy read_toy(const JsonValue& item, Reading& reading) {
  Toy toy;
  ToyText common;
  if (item.has("cloth")) {
    const auto text = read<ClothToyText>(item);
    common = text.toy;
    toy = read_cloth(*text.cloth, reading);
  } else {
    const auto text = read<ParticlesText>(item);
    common = text.toy;
    toy = read_parts(text, reading);
  }
  toy.gravity = reading.scene.hair.gravity;
  toy.wind = reading.scene.hair.wind;
  toy.method = *toy_methods()[common.method].toy;
  toy.drag = common.drag;
  if (toy.method == ToyMethod::implicit_euler && toy.constraints.rows() > 0)
    item["method"].fail("rods and wires need an explicit method");
  return toy;
}

}  // namespace

std::vector<ObjectKind> kinds_of_toys() {
  return {object<ParticlesText>(), object<ClothToyText>(" with a cloth")};
}

void add_toys(const JsonValue& list, Reading& reading) {
  for (const JsonValue& item : list.items()) reading.scene.toys.push_back(read_toy(item, reading));
}

}  // namespace hair::json
