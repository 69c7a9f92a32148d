#include "hair/lab/pictures.h"

namespace hair {

namespace {

RenderSettings settings_of(const Look& look) {
  return {.width = look.image_width, .height = look.image_height, .shadows = look.shadows, .library = {}};
}

}  // namespace

Pictures::Pictures(const Scene& scene) : scene_(scene), renderer_(settings_of(*scene.look)) {
  renderer_.measure(true);
}

Image Pictures::draw(const particles::State& state, const std::vector<Obstacle>& obstacles) {
  Drawing drawing;
  Eigen::Index at = 0;
  for (const StrandStart& start : scene_.hair.strands) {
    drawing.strands.sizes.push_back(start.strand.count());
    for (int i = 0; i < start.strand.count(); ++i, at += 3)
      drawing.strands.points.push_back(state.x.segment<3>(at));
  }
  drawing.obstacles = obstacles;
  Bounds bounds;
  for (const Vector3d& point : drawing.strands.points) bounds.add(point);
  return renderer_.draw(drawing, frame_camera(bounds, 16.0 / 9));
}

}  // namespace hair
