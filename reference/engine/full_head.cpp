// STAFF ONLY. The engine's host side: groups of strands, their memory, and threads over them.

#include "hair/dense/full_head.h"

#include <hwy/aligned_allocator.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "hair/length_correction.h"
#include "hair/predictor_corrector.h"
#include "hair/simulation/strand_threads.h"
#include "particles/require.h"
#include "reference/engine/distance_grid.h"
#include "reference/engine/group.h"

namespace hair {

namespace {

using engine::Group, engine::kGroup;
using particles::require, particles::require_at_least, particles::require_direction,
    particles::require_finite, particles::require_positive;

void check_settings(const FullHeadSettings& settings) {
  require_positive("a hair's radius", settings.material.radius);
  require_positive("a hair's density", settings.material.density);
  require_at_least("a hair's Young's modulus", settings.material.young_modulus, 0);
  require_at_least("drag", settings.drag, 0);
  require_at_least("a head's friction", settings.friction, 0);
  require_at_least("threads", settings.threads, 1);
  require_finite("gravity", settings.gravity);
  require_finite("wind", settings.wind);
}

// The map from the world to a grid's cells.
Eigen::Affine3d cells_of(const engine::GridView& grid, const Eigen::Isometry3d& pose) {
  return Eigen::Scaling(grid.per_cell) *
         Eigen::Translation3d(-Vector3d(grid.low[0], grid.low[1], grid.low[2])) * pose.inverse();
}

template <typename Transform>
engine::Pose pose_of(const Transform& transform) {
  engine::Pose pose{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.turn[row][column] = transform.linear()(row, column);
    pose.at[row] = transform.translation()[row];
  }
  return pose;
}

// Asks for pages of 2 MB, where the system has them on request: a step walks through all of this memory.
void ask_for_large_pages([[maybe_unused]] double* memory, [[maybe_unused]] std::size_t numbers) {
#ifdef __linux__
  constexpr std::size_t kPage = 1 << 21;
  void* begin = memory;
  std::size_t bytes = numbers * sizeof(double);
  // If the system refuses, the step only takes longer.
  if (std::align(kPage, kPage, begin, bytes)) static_cast<void>(madvise(begin, bytes, MADV_HUGEPAGE));
#endif
}

// A task has at most so many groups.
constexpr int kLongestRun = 32;

// Memory that each thread has for itself.
struct ThreadMemory {
  explicit ThreadMemory(std::size_t points)
      : near_row(kGroup * (points + 2)),
        numbers(kGroup * ((points + 1) * engine::kFactorRow + 6 * points)),
        doubles(hwy::AllocateAligned<double>(numbers)),
        floats(hwy::AllocateAligned<float>(engine::kNearRows * near_row)),
        integers(hwy::AllocateAligned<std::int32_t>(near_row)),
        view{doubles.get(),
             doubles.get() + engine::kFactorRow * (points + 1) * kGroup,
             doubles.get() + (engine::kFactorRow * (points + 1) + 3 * points) * kGroup,
             floats.get(),
             integers.get(),
             near_row} {}
  std::size_t bytes() const {
    return numbers * sizeof(double) + (engine::kNearRows * sizeof(float) + sizeof(std::int32_t)) * near_row;
  }

  std::size_t near_row, numbers;
  hwy::AlignedFreeUniquePtr<double[]> doubles;
  hwy::AlignedFreeUniquePtr<float[]> floats;
  hwy::AlignedFreeUniquePtr<std::int32_t[]> integers;
  engine::Scratch view;
};

}  // namespace

struct FullHead::Engine {
  Engine(std::span<const int> points, const FullHeadSettings& settings);

  // The place of a strand in the groups.
  struct Place {
    std::int32_t group;
    std::int32_t lane;
  };
  void repeat_last();

  FullHeadSettings settings;
  std::optional<engine::DistanceGrid> grid;
  engine::StepGroup step_group = nullptr;
  std::vector<Place> places;  // one for each strand
  std::vector<Group> groups;
  std::vector<std::int64_t> broke_at;
  hwy::AlignedFreeUniquePtr<double[]> memory;
  std::size_t memory_size = 0;
  std::vector<ThreadMemory> scratch;
  std::int64_t particles = 0, steps = 0;
  int unset = 0;
  std::vector<char> is_set;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  StrandThreads threads;
};

FullHead::Engine::Engine(std::span<const int> points, const FullHeadSettings& the_settings)
    : settings((check_settings(the_settings), the_settings)),
      places(points.size()),
      unset(static_cast<int>(points.size())),
      is_set(points.size(), 0),
      threads(settings.threads) {
  if (settings.head) {
    grid.emplace(*settings.head, settings.grid_spacing);
    const double rounding = engine::place_rounding(grid->view());
    require(rounding <= kContactDepth / 2, "the rounding of places on a head's grid", rounding,
            "at most 5e-7 m: the head is at most 1 m wide");
  }
  step_group = engine::step_group_for({settings.bending, settings.correct_lengths, settings.head != nullptr});

  for (const int n : points) {
    require(n >= 2 && n <= kMostStrandPoints, "a strand's number of points", n, "2 to 10000");
    particles += n;
  }
  // Strands of the same number of points share groups.
  std::vector<std::int32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return points[a] < points[b]; });
  std::size_t lane = kGroup;
  for (const int k : order) {
    if (lane == kGroup || groups.back().points != points[k]) {
      groups.emplace_back().points = points[k];
      lane = 0;
    }
    places[k] = {static_cast<std::int32_t>(groups.size()) - 1, static_cast<std::int32_t>(lane++)};
  }

  for (const Group& group : groups) memory_size += (6 * group.points + 7) * kGroup;
  memory = hwy::AllocateAligned<double>(memory_size);
  ask_for_large_pages(memory.get(), memory_size);
  broke_at.assign(groups.size() * kGroup, 0);
  std::fill_n(memory.get(), memory_size, 0.0);
  double* next = memory.get();
  const auto take = [&](std::size_t numbers) { return (next += numbers * kGroup) - numbers * kGroup; };
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Group& group = groups[g];
    group.x = take(3 * group.points);
    group.v = take(3 * group.points);
    group.root = take(3);
    group.tangent = take(3);
    group.rest_length = take(1);
    group.broke_at = broke_at.data() + g * kGroup;
  }
  const int most = groups.empty() ? 0 : groups.back().points;
  for (int thread = 0; thread < settings.threads; ++thread) scratch.emplace_back(most);
}

// Fills the lanes that no strand has.
void FullHead::Engine::repeat_last() {
  std::vector<std::int32_t> used(groups.size(), 0);
  for (const Place& place : places) used[place.group] = std::max(used[place.group], place.lane + 1);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    const std::size_t rows = 6 * group.points + 7;  // x, v, root, tangent and rest_length follow each other
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t lane = used[g]; lane < kGroup; ++lane)
        group.x[row * kGroup + lane] = group.x[row * kGroup + used[g] - 1];
  }
}

FullHead::FullHead(std::span<const int> points, const FullHeadSettings& settings)
    : engine_(std::make_unique<Engine>(points, settings)) {}

FullHead::~FullHead() = default;

int FullHead::strands() const {
  return static_cast<int>(engine_->places.size());
}

std::int64_t FullHead::particles() const {
  return engine_->particles;
}

void FullHead::set_strand(int k, double rest_length, const Vector3d& root_tangent, particles::Input x,
                          particles::Input v) {
  const auto [g, lane] = engine_->places.at(k);
  const Group& group = engine_->groups[g];
  require_positive("a strand's rest length", rest_length);
  require_direction("a root's tangent", root_tangent);
  const Eigen::Index numbers = 3 * group.points;
  require(x.size() == numbers && v.size() == numbers, "the size of a strand's x and v",
          static_cast<double>(x.size()), "3 times its points");
  for (Eigen::Index i = 0; i < numbers; ++i) {
    group.x[i * kGroup + lane] = x[i];
    group.v[i * kGroup + lane] = v[i];
  }
  for (int axis = 0; axis < 3; ++axis) {
    group.root[axis * kGroup + lane] = x[axis];
    group.tangent[axis * kGroup + lane] = root_tangent[axis];
  }
  group.rest_length[lane] = rest_length;
  if (!engine_->is_set[k]) {
    engine_->is_set[k] = 1;
    if (--engine_->unset == 0) engine_->repeat_last();
  }
}

void FullHead::step(double h, const Eigen::Isometry3d& pose) {
  Engine& engine = *engine_;
  require_positive("a step", h);
  require(engine.unset == 0, "strands that were not set", engine.unset,
          "0: set_strand is due for each strand");
  const FullHeadSettings& s = engine.settings;
  const double bend = s.material.bend_rigidity() / s.material.line_density();
  engine::StepConstants step{};
  step.h = h;
  step.per_h = 1 / h;
  step.drag = h * s.drag;
  step.mass = 1 + step.drag;
  for (int axis = 0; axis < 3; ++axis) step.push[axis] = h * s.gravity[axis] + step.drag * s.wind[axis];
  step.stretch = h * h * s.material.stretch_rigidity() / s.material.line_density();
  step.bend = h * h * bend;
  step.clamp = s.clamped ? 2 * step.bend : 0;
  step.length_tolerance = kLengthTolerance;
  step.friction = s.friction;
  if (engine.grid) {
    step.grid = engine.grid->view();
    step.cells_before = pose_of(cells_of(step.grid, engine.pose));
    step.cells_after = pose_of(cells_of(step.grid, pose));
    step.contact_depth = kContactDepth - engine::place_rounding(step.grid);
  }
  step.after = pose_of(pose);
  step.step = ++engine.steps;
  // A task is a run of neighbouring groups, so that the same core needs the state that is fetched ahead
  // (Sweep::fetch_next). Runs stay short enough for threads to end together.
  const int groups = static_cast<int>(engine.groups.size());
  struct Work {
    const Engine& engine;
    const engine::StepConstants& step;
    int run;
  } const work{engine, step, std::clamp(groups / (16 * s.threads), 1, kLongestRun)};
  // One reference fits into a std::function.
  const StrandThreads::Task task = [&work](int thread, int t) {
    const Engine& all = work.engine;
    const int begin = t * work.run, end = std::min(begin + work.run, static_cast<int>(all.groups.size()));
    for (int g = begin; g < end; ++g) all.step_group(work.step, all.groups[g], all.scratch[thread].view);
  };
  engine.threads.run((groups + work.run - 1) / work.run, task);
  engine.pose = pose;
}

void FullHead::get_strand(int k, particles::Output x, particles::Output v) const {
  const auto [g, lane] = engine_->places.at(k);
  const Group& group = engine_->groups[g];
  for (Eigen::Index i = 0; i < 3 * group.points; ++i) {
    x[i] = group.x[i * kGroup + lane];
    v[i] = group.v[i * kGroup + lane];
  }
}

std::int64_t FullHead::broke_at(int k) const {
  const auto [g, lane] = engine_->places.at(k);
  return engine_->groups[g].broke_at[lane];
}

int FullHead::broken() const {
  int count = 0;
  for (int k = 0; k < strands(); ++k) count += broke_at(k) != 0;
  return count;
}

std::size_t FullHead::bytes() const {
  const Engine& e = *engine_;
  std::size_t scratch = 0;
  for (const ThreadMemory& memory : e.scratch) scratch += memory.bytes();
  return scratch + e.memory_size * sizeof(double) + e.broke_at.size() * sizeof(std::int64_t) +
         e.groups.size() * sizeof(Group) + e.places.size() * (sizeof(Engine::Place) + 1) +
         (e.grid ? e.grid->bytes() : 0);
}

}  // namespace hair
