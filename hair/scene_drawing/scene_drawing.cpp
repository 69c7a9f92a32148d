#include "hair/scene_drawing/scene_drawing.h"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "hair/head/kept_net.h"
#include "hair/render/light.h"
#include "hair/render/view.h"
#include "hair/scene_drawing/scene_bounds.h"
#include "particles/require.h"

namespace hair {
namespace {

// Toys have different colours, and pinned particles are dark.
const std::array<Colour, 5> kToyColours = {Colour(0.60F, 0.09F, 0.06F), Colour(0.05F, 0.22F, 0.50F),
                                           Colour(0.10F, 0.35F, 0.12F), Colour(0.60F, 0.36F, 0.03F),
                                           Colour(0.32F, 0.10F, 0.38F)};
const Colour kPinned(0.06F, 0.06F, 0.07F), kRod(0.20F, 0.22F, 0.25F), kWire(0.45F, 0.36F, 0.12F),
    kLink(0.05F, 0.22F, 0.50F);

// Relative to the picture's height.
constexpr double kBall = 0.018, kTube = 0.005, kRing = 0.0035, kThread = 0.0006;

constexpr std::uint32_t kFirstStillId = 1U << 30;  // above the numbers of moving strands

// The four sides of the camera's view. With shadows, the sides from which light comes are no limits: hair
// beyond them may have a shadow in the picture.
std::vector<Plane> seen_planes(const Camera& camera, double aspect, bool shadows) {
  const Eigen::Matrix3d axes = view_axes((camera.eye - camera.target).normalized(), camera.up);
  const double y = std::tan(camera.field_of_view / 2), x = aspect * y;
  std::vector<Plane> planes;
  for (const Vector3d& inward :
       {Vector3d(1, 0, -x), Vector3d(-1, 0, -x), Vector3d(0, 1, -y), Vector3d(0, -1, -y)})
    if (!shadows || inward.dot(kKeyLight.cast<double>()) >= 0)
      planes.push_back({camera.eye, axes.transpose() * inward.normalized()});
  return planes;
}

int last_guide(const DenseHair& dense) {
  return dense.first + static_cast<int>(dense.description.guides.size()) - 1;
}

}  // namespace

SceneDrawing::SceneDrawing(const Scene& scene, std::vector<int> strands,
                           const std::optional<std::filesystem::path>& cache, int cells)
    : scene_(scene), strands_(std::move(strands)), look_(scene.look.value_or(Look())) {
  const double aspect = static_cast<double>(look_.image_width) / look_.image_height;
  camera_ = look_.frame ? frame_points(scene_outline(scene), aspect, look_.view)
                        : frame_camera(scene_bounds(scene), aspect, look_.view);
  for (const Obstacle& obstacle : scene.hair.obstacles)
    if (const auto* const placed = std::get_if<PlacedSolid>(&obstacle.shape))
      meshes_.push_back(std::make_shared<SurfaceMesh>(kept_surface_net(*placed->solid, cells, cache)));
  const Vector3d target = look_.look_at.value_or(camera_.target);
  camera_.eye = target + (camera_.eye - camera_.target) / look_.zoom;
  camera_.target = target;
  unit_ = 2 * std::tan(camera_.field_of_view / 2) * (camera_.eye - camera_.target).norm();
  view_ = seen_planes(camera_, aspect, look_.shadows);
  for (const DenseHair& dense : scene.dense)
    dense_.push_back(std::make_unique<Synthesis>(dense.description, scene.hair.jobs));
  for (const StillHair& hair : scene.still)
    still_.push_back(grow_groom(*hair.head, hair.style, hair.settings));
  if (look_.fine_hair && !dense_.empty() && !scene.hair.obstacles.empty())
    clearance_ = std::make_unique<StrandClearance>(scene.hair.obstacles, scene.hair.jobs);
}

RenderSettings SceneDrawing::settings() const {
  return {.width = look_.image_width, .height = look_.image_height, .shadows = look_.shadows};
}

Drawing SceneDrawing::at(const particles::State& state, const std::vector<Obstacle>& obstacles, double time,
                         const MeshRecord* mesh) const {
  Drawing drawing;
  drawing.obstacles = obstacles;
  for (const Obstacle& obstacle : obstacles)
    if (const auto* const placed = std::get_if<PlacedSolid>(&obstacle.shape))
      drawing.meshes.push_back({meshes_.at(drawing.meshes.size()), placed->at, placed->rotation});
  drawing.strands.width = look_.width;
  drawing.strands.fine = look_.fine_hair;
  drawing.strands.root = look_.root_colour.cast<float>();
  drawing.strands.tip = look_.tip_colour.cast<float>();
  Eigen::Index particles = std::accumulate(strands_.begin(), strands_.end(), Eigen::Index{0});
  const Eigen::Index of_strands = particles;
  for (const Toy& toy : scene_.toys) particles += toy.particles.count();
  particles::require(state.x.size() == 3 * particles, "the number of the state's coordinates",
                     static_cast<double>(state.x.size()),
                     std::to_string(3 * particles) + ", 3 for each particle");

  add_strands(state.x.head(3 * of_strands), obstacles, time, drawing.strands);
  if (look_.links && scene_.hair.mesh) add_links(state.x.head(3 * of_strands), mesh, drawing);
  std::uint32_t still_id = kFirstStillId;
  for (std::size_t i = 0; i < still_.size(); ++i)
    add_still(scene_.still[i], still_[i], time, still_id, drawing.strands);
  Eigen::Index first = of_strands;
  int toy_index = 0;
  for (const Toy& toy : scene_.toys) {
    add_toy(toy, toy_index++, state.x.segment(3 * first, 3 * toy.particles.count()), drawing);
    first += toy.particles.count();
  }
  return drawing;
}

void SceneDrawing::add_strands(particles::Input x, const std::vector<Obstacle>& obstacles, double time,
                               StrandsDrawing& drawing) const {
  synthesised_ = {};
  moved_out_ = 0;
  drawing.points.reserve(static_cast<std::size_t>(x.size() / 3));
  Eigen::Index at = 0;
  std::size_t group = 0;
  for (std::size_t strand = 0; strand < strands_.size();) {
    if (group < dense_.size() && scene_.dense[group].first == static_cast<int>(strand)) {
      const SynthesisDescription& made = scene_.dense[group].description;
      const Eigen::Index size = 3 * static_cast<Eigen::Index>(made.guides.size()) * made.points;
      particles::require(at + size <= x.size(), "the numbers of a group's guides", static_cast<double>(size),
                         "within the state's");
      const std::size_t first = drawing.sizes.size(), first_point = drawing.points.size();
      add_dense(group++, x.segment(at, size), time, drawing);
      if (clearance_ && !obstacles.empty())
        moved_out_ += clearance_->move_out(obstacles, drawing, first, first_point);
      strand += made.guides.size();
      at += size;
      continue;
    }
    if (drawing.fine) drawing.ids.push_back(static_cast<std::uint32_t>(strand));
    drawing.sizes.push_back(strands_[strand]);
    for (int i = 0; i < strands_[strand]; ++i, at += 3) drawing.points.emplace_back(x.segment<3>(at));
    ++strand;
  }
}

Way SceneDrawing::way(const std::optional<Motion>& motion, double time) const {
  return motion ? hand_ * way_at(*motion, time) : Way{};
}

void SceneDrawing::add_dense(std::size_t group, particles::Input guides, double time,
                             StrandsDrawing& drawing) const {
  const Eigen::Matrix3d turn = way(scene_.dense[group].motion, time).rotation.toRotationMatrix();
  Synthesis& synthesis = *dense_[group];
  std::vector<double> made(3 * static_cast<std::size_t>(synthesis.points()) * synthesis.children());
  const SynthesisCounts counts = synthesis.make({guides.data(), static_cast<std::size_t>(guides.size())},
                                                turn, view_, std::span<double>(made));
  const auto points = static_cast<std::size_t>(counts.children) * synthesis.points();
  drawing.sizes.insert(drawing.sizes.end(), static_cast<std::size_t>(counts.children), synthesis.points());
  if (drawing.fine)
    for (const int child : synthesis.in_view())
      drawing.ids.push_back(static_cast<std::uint32_t>(scene_.dense[group].first + child));
  for (std::size_t i = 0; i < points; ++i)
    drawing.points.emplace_back(Eigen::Map<const Vector3d>(made.data() + 3 * i));
  synthesised_.children += counts.children;
  synthesised_.children_out_of_view += counts.children_out_of_view;
  synthesised_.guides_used += counts.guides_used;
  synthesised_.guides_idle += counts.guides_idle;
}

void SceneDrawing::add_still(const StillHair& hair, const Groom& grown, double time, std::uint32_t& id,
                             StrandsDrawing& drawing) const {
  const Way there = way(hair.motion, time);
  for (const Eigen::VectorXd& x : grown.strands) {
    drawing.sizes.push_back(static_cast<int>(x.size() / 3));
    if (drawing.fine) drawing.ids.push_back(id++);
    for (Eigen::Index i = 0; i < x.size(); i += 3) drawing.points.push_back(there(x.segment<3>(i) + hair.at));
  }
}

void SceneDrawing::add_links(particles::Input x, const MeshRecord* mesh, Drawing& drawing) const {
  std::vector<char> hidden;  // by particles
  hidden.reserve(static_cast<std::size_t>(x.size() / 3));
  std::size_t group = 0;
  int strand = 0;
  for (const int points : strands_) {
    while (group < scene_.dense.size() && last_guide(scene_.dense[group]) < strand) ++group;
    const bool guide = group < scene_.dense.size() && scene_.dense[group].first <= strand;
    hidden.insert(hidden.end(), static_cast<std::size_t>(points), guide ? 1 : 0);
    ++strand;
  }
  const std::vector<StaticLink>& links = scene_.hair.mesh->links;
  std::vector<char> broken(links.size(), 0);
  if (mesh != nullptr)
    for (const BrokenLink& one : mesh->broken) broken.at(static_cast<std::size_t>(one.link)) = 1;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto a = static_cast<std::size_t>(links[i].a), b = static_cast<std::size_t>(links[i].b);
    if (broken[i] || hidden.at(a) || hidden.at(b)) continue;
    drawing.tubes.push_back(
        {x.segment<3>(3 * links[i].a), x.segment<3>(3 * links[i].b), kThread * unit_, kLink});
  }
}

void SceneDrawing::add_toy(const Toy& toy, int toy_index, particles::Input x, Drawing& drawing) const {
  const Colour& colour = kToyColours[static_cast<std::size_t>(toy_index) % kToyColours.size()];
  const auto point = [&](int i) { return Vector3d(x.segment<3>(3 * i)); };
  const int cloth = toy.rows > 1 && toy.columns > 1 ? toy.rows * toy.columns : 0;
  if (cloth > 0) {
    Sheet sheet{toy.rows, toy.columns, {}, colour};
    for (int i = 0; i < cloth; ++i) sheet.points.push_back(point(i));
    drawing.sheets.push_back(sheet);
  }
  for (const particles::Spring& spring : toy.springs) {
    if (spring.i < cloth && spring.j < cloth) continue;
    drawing.tubes.push_back({point(spring.i), point(spring.j), kTube * unit_, colour});
  }
  for (const particles::Rod& rod : toy.constraints.rods) {
    drawing.tubes.push_back({point(rod.i), point(rod.j), kTube * unit_, kRod});
  }
  for (int i = 0; i < toy.particles.count(); ++i) {
    const bool pinned = toy.particles.is_pinned(i);
    if (i < cloth && !pinned) continue;
    drawing.balls.push_back({point(i), (i < cloth ? kTube : kBall) * unit_, pinned ? kPinned : colour});
  }
  for (const particles::Wire& wire : toy.constraints.wires) {
    drawing.rings.push_back({wire.centre, wire.normal, wire.radius, kRing * unit_, kWire});
  }
}

}  // namespace hair
