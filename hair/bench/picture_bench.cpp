// What a picture of fine hair costs, by the number of its strands: 1280 x 720, 16 points a strand, a bust under hair that
// `head/grow.h` grows.
//
// `picture_bench 5000` measures this number alone.
//
// CPU time of all threads and the time that passes, the least of a few pictures; beside it, in the same run, how many times as long
// as a copy of the strands' points a picture takes, and the most memory that the process had.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "hair/head/bust.h"
#include "hair/head/grow.h"
#include "hair/head/hair_style.h"
#include "hair/render/renderer.h"
#include "hair/render/strand_clearance.h"
#include "solver/timing.h"

namespace {

using namespace hair;

constexpr int kPoints = 16, kPictures = 3;

struct Cost {
  double wall = 1e300, cpu = 1e300;
};

template <class Work>
Cost least(const Work& work) {
  Cost cost;
  for (int i = 0; i < kPictures; ++i) {
    const double wall = timing::wall_seconds(), cpu = timing::process_cpu_seconds();
    work();
    cost.wall = std::min(cost.wall, timing::wall_seconds() - wall);
    cost.cpu = std::min(cost.cpu, timing::process_cpu_seconds() - cpu);
  }
  return cost;
}

Drawing hair_on_bust(int count, const std::shared_ptr<SurfaceMesh>& bust) {
  Drawing drawing;
  StrandsDrawing& strands = drawing.strands;
  strands.fine = true;
  strands.width = std::clamp(8.0 / count, 8e-5, 4e-4);
  for (const Eigen::VectorXd& strand :
       grow_groom(Bust(), *find_hair_style("long-smooth"), {count, kPoints, 1}).strands) {
    strands.sizes.push_back(kPoints);
    for (int i = 0; i < kPoints; ++i) strands.points.emplace_back(strand.segment<3>(3 * i));
  }
  drawing.meshes.push_back({bust, Vector3d::Zero(), Eigen::Quaterniond::Identity()});
  return drawing;
}

// What it costs to move strands out of a bust, half of which dip into it: hair that grows on it, a little smaller.
void print_clearance(int count, const std::shared_ptr<SurfaceMesh>& bust) {
  const std::vector<Obstacle> obstacles = {{PlacedSolid{std::make_shared<Bust>()}}};
  const Drawing drawing = hair_on_bust(count, bust);
  StrandsDrawing inside = drawing.strands, moved;
  for (std::size_t i = 0; i < inside.points.size(); ++i)
    if (i / kPoints % 2 == 0 && i % kPoints != 0) inside.points[i] *= 0.97;
  const Cost grid = least([&] { StrandClearance clearance(obstacles, 1); });
  StrandClearance clearance(obstacles, 1);
  const Cost copy = least([&] { moved = inside; });
  const Cost all = least([&] {
    moved = inside;
    clearance.move_out(obstacles, moved, 0, 0);
  });
  std::printf(
      "\n%d strands moved out of the bust, one thread: %.2f CPU s, and once %.3f CPU s for the grid\n", count,
      all.cpu - copy.cpu, grid.cpu);
}

}  // namespace

int main(int arguments, char** values) {
  std::vector<int> counts = {1'000, 10'000, 50'000, 150'000};
  if (arguments > 1) counts = {std::max(1, std::atoi(values[1]))};
  const auto bust = std::make_shared<SurfaceMesh>(surface_net(Bust(), 220));
  const Camera camera = frame_points(bust->points, 1280.0 / 720, Vector3d(0.6, -1, 0.15));
  std::puts(
      "| strands | s | CPU s | frames/s | without shadows: CPU s | strands a CPU s | of memcpy | memory, MB "
      "|");
  std::puts("|--:|--:|--:|--:|--:|--:|--:|--:|");
  for (const int count : counts) {
    const Drawing drawing = hair_on_bust(count, bust);
    Renderer renderer({}), bright({.shadows = false});
    const Cost all = least([&] { renderer.draw(drawing, camera); });
    const Cost plain = least([&] { bright.draw(drawing, camera); });
    const std::vector<Vector3d>& from = drawing.strands.points;
    std::vector<Vector3d> to(from.size());
    const Cost copy = least([&] { std::copy(from.begin(), from.end(), to.begin()); });
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    std::printf("| %d | %.2f | %.2f | %.2g | %.2f | %.0f | %.0f | %.0f |\n", count, all.wall, all.cpu,
                1 / all.wall, plain.cpu, count / all.cpu, all.wall / copy.wall,
                static_cast<double>(use.ru_maxrss) / 1024);
    std::fflush(stdout);
  }
  print_clearance(counts.back(), bust);
  return 0;
}
