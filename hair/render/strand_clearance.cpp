#include "hair/render/strand_clearance.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace hair {
namespace {

constexpr double kCell = 0.008;          // m, of the grid
constexpr double kRiseOfHair = 0.25;     // strands rise from their roots at this slope
constexpr int kRounds = 3, kPasses = 3;  // rounds of moving out, and passes of smoothing in each
constexpr int kMostPushes = 40;          // deep inside, a distance is not exact
constexpr int kStrandsOfAMove = 64;

// Spreads consecutive numbers evenly over 0 to 1: multiples of the golden ratio.
double place_in_layer(std::uint32_t id) {
  const double place = 0.6180339887498949 * id;
  return place - std::floor(place);
}

// Each move except the root's becomes the mean of itself and of its neighbours' mean.
void smooth(std::vector<Vector3d>& moves) {
  Vector3d before = moves.front();
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Vector3d own = moves[i], beyond = moves[std::min(i + 1, moves.size() - 1)];
    moves[i] = 0.25 * (before + beyond) + 0.5 * own;
    before = own;
  }
}

}  // namespace

struct StrandClearance::Scratch {
  std::vector<double> lengths, clearances;
  std::vector<Vector3d> start, moves;

  void resize(int count) {
    const auto size = static_cast<std::size_t>(count);
    lengths.resize(size);
    clearances.resize(size);
    start.resize(size);
    moves.resize(size);
  }
};

StrandClearance::NearCells::NearCells(const Solid& solid, double wanted) : cell(wanted) {
  const Eigen::AlignedBox3d box = solid.box();
  low = box.min().array() - kHigh;
  for (int axis = 0; axis < 3; ++axis)
    size[axis] = static_cast<int>(std::ceil((box.sizes()[axis] + 2 * kHigh) / cell));
  near.reserve(static_cast<std::size_t>(size[0]) * size[1] * size[2]);
  // A solid's distance is at most about twice the true one.
  const double free = 2.2 * (std::sqrt(3.0) / 2 * cell + kHigh);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        near.push_back(
            solid.surface_at(low + cell * Vector3d(i + 0.5, j + 0.5, k + 0.5)).distance < free ? 1 : 0);
}

bool StrandClearance::NearCells::may_touch(const Vector3d& point) const {
  const Vector3d at = (point - low) / cell;
  for (int axis = 0; axis < 3; ++axis)
    if (!(at[axis] >= 0 && at[axis] < size[axis])) return false;
  const auto i = static_cast<std::size_t>(at[0]), j = static_cast<std::size_t>(at[1]),
             k = static_cast<std::size_t>(at[2]);
  return near[i + static_cast<std::size_t>(size[0]) * (j + static_cast<std::size_t>(size[1]) * k)] != 0;
}

StrandClearance::StrandClearance(const std::vector<Obstacle>& obstacles, int threads) : threads_(threads) {
  for (const Obstacle& obstacle : obstacles) {
    const auto* const placed = std::get_if<PlacedSolid>(&obstacle.shape);
    cells_.emplace_back();
    if (placed) cells_.back().emplace(*placed->solid, kCell);
  }
}

// True if a point is inside an obstacle, or nearer to it than `clearance`.
bool StrandClearance::touches(const std::vector<Obstacle>& now, const Vector3d& point,
                              double clearance) const {
  return !way_out(now, point, clearance).isZero(0);
}

// The vector that moves a point out of the obstacle in which it is deepest; 0 if it is clear of all.
Vector3d StrandClearance::way_out(const std::vector<Obstacle>& now, const Vector3d& point,
                                  double clearance) const {
  double deepest = 0;
  Vector3d way = Vector3d::Zero();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i]) {
      const auto& placed = std::get<PlacedSolid>(now[i].shape);
      if (!cells_[i]->may_touch(placed.rotation.conjugate() * (point - placed.at))) continue;
    }
    const Surface surface = surface_at(now[i], point);
    const double depth = clearance - surface.distance;
    if (depth <= deepest) continue;
    deepest = depth;
    way = depth * surface.normal;
  }
  return way;
}

// Returns true if the strand moved.
bool StrandClearance::move_strand_out(const std::vector<Obstacle>& now, Vector3d* points, int count,
                                      std::uint32_t id, Scratch& scratch) const {
  scratch.resize(count);
  std::vector<double>&lengths = scratch.lengths, &clearances = scratch.clearances;
  std::vector<Vector3d>&start = scratch.start, &moves = scratch.moves;
  const double layer = std::lerp(kLow, kHigh, place_in_layer(id));
  double along = 0;
  bool any = false;
  for (int i = 1; i < count; ++i) {
    lengths[i] = (points[i] - points[i - 1]).norm();
    along += lengths[i];
    clearances[i] = std::min(layer, kRiseOfHair * along);
    any = any || touches(now, points[i], 0.5 * clearances[i]);
  }
  if (!any) return false;
  std::copy_n(points, count, start.begin());
  std::fill(moves.begin(), moves.end(), Vector3d::Zero());
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 1; i < count; ++i) moves[i] += way_out(now, points[i], clearances[i]);
    for (int pass = 0; pass < kPasses; ++pass) smooth(moves);
    for (int i = 1; i < count; ++i) points[i] = start[i] + moves[i];
  }
  for (int i = 1; i < count; ++i) {
    const Vector3d piece = points[i] - points[i - 1];
    const double length = piece.norm();
    if (length > 0) points[i] = points[i - 1] + lengths[i] / length * piece;
  }
  for (int i = 1; i < count; ++i)
    for (int push = 0; push < kMostPushes; ++push) {
      const Vector3d way = way_out(now, points[i], 0.5 * clearances[i]);
      if (way.isZero(0)) break;
      points[i] += way;
    }
  return true;
}

long StrandClearance::move_out(const std::vector<Obstacle>& now, StrandsDrawing& strands, std::size_t first,
                               std::size_t first_point) {
  if (cells_.empty()) return 0;
  // The index of each task's first point.
  const auto strand_count = static_cast<int>(strands.sizes.size() - first);
  std::vector<std::size_t> begins;
  std::size_t next = first_point;
  for (int i = 0; i < strand_count; ++i) {
    if (i % kStrandsOfAMove == 0) begins.push_back(next);
    next += static_cast<std::size_t>(strands.sizes[first + static_cast<std::size_t>(i)]);
  }
  std::vector<Scratch> scratch(static_cast<std::size_t>(threads_.count()));
  std::atomic<long> moved = 0;
  threads_.run(static_cast<int>(begins.size()), [&](int thread, int task) {
    Vector3d* points = strands.points.data() + begins[static_cast<std::size_t>(task)];
    const int end = std::min(strand_count, (task + 1) * kStrandsOfAMove);
    long of_task = 0;
    for (int i = task * kStrandsOfAMove; i < end; ++i) {
      const std::size_t strand = first + static_cast<std::size_t>(i);
      const std::uint32_t id = strands.id(strand);
      of_task +=
          move_strand_out(now, points, strands.sizes[strand], id, scratch[static_cast<std::size_t>(thread)]);
      points += strands.sizes[strand];
    }
    moved += of_task;
  });
  return moved;
}

}  // namespace hair
