#include "hair/lab/run/pictures.h"

namespace hair {

Pictures::Pictures(const Scene& scene, const std::vector<int>& strands,
                   const std::optional<std::filesystem::path>& cache)
    : drawing_(scene, strands, cache), renderer_(drawing_.settings()) {
  renderer_.measure(true);
}

Image Pictures::draw(const particles::State& state, const std::vector<Obstacle>& obstacles, double time,
                     const MeshRecord* mesh) {
  return renderer_.draw(drawing_.at(state, obstacles, time, mesh), drawing_.camera());
}

}  // namespace hair
