// STAFF ONLY. Runs the reference, and measures its distance to a worker's run.
#include "grader/judge/run/run_comparison.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "grader/judge/run/play_scene.h"
#include "hair/scene_drawing/scene_drawing.h"
#include "hair/view/motion.h"

namespace grader::inline judge {
namespace {

// A smaller distance, relative to the scene's size, can't be seen: it is a thousandth of a pixel.
constexpr double kSameParticles = 1e-6;
// A particle that is nearer than this tells a student almost nothing beyond the reference's picture.
constexpr double kNear = 0.01;
// A picture would not show a run that goes further out than this, in the scene's size.
constexpr double kFarthestDrawn = 100;

std::string name_at(double time) {
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(2);
  text << time << " s";
  return text.str();
}

// Lists the points that follow a given motion: the roots of strands, and pinned particles of toys.
std::vector<bool> held_points(const hair::Scene& scene, const std::vector<int>& strands) {
  std::vector<bool> held;
  for (const int points : strands)
    for (int i = 0; i < points; ++i) held.push_back(i == 0);
  for (const hair::Toy& toy : scene.toys)
    for (int i = 0; i < toy.particles.count(); ++i) held.push_back(toy.particles.is_pinned(i));
  return held;
}

// This camera is nearer than a scene's own one, which has room for everything. A scene with more to see than
// particles and wires keeps its own.
hair::Camera camera_of(const hair::Scene& scene, const hair::SceneDrawing& drawing, hair::Bounds bounds) {
  if (!scene.hair.obstacles.empty()) return drawing.camera();
  for (const hair::Toy& toy : scene.toys)
    for (const particles::Wire& wire : toy.constraints.wires) {
      const Eigen::Vector3d reach = wire.radius * (1 - wire.normal.array().square()).max(0).sqrt();
      bounds.extend(wire.centre - reach);
      bounds.extend(wire.centre + reach);
    }
  return hair::frame_camera(bounds, static_cast<double>(kPictureWidth) / kPictureHeight,
                            scene.look.value_or(hair::Look()).view);
}

bool is_finite(const particles::State& state) {
  return state.x.allFinite() && state.v.allFinite();
}

double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b, std::size_t i) {
  const auto at = static_cast<Eigen::Index>(3 * i);
  return (a.segment<3>(at) - b.segment<3>(at)).norm();
}

// Holds a frame that can be drawn.
struct Taken {
  int frame = 0;
  Moment moment;
  particles::State ours, theirs;
  Eigen::VectorXd our_dense, their_dense;
  std::vector<hair::Obstacle> obstacles;
};

// Draws dense hair in the place of all strands.
hair::Drawing with_dense(hair::Drawing drawing, const std::vector<int>& sizes, const Eigen::VectorXd& dense) {
  drawing.strands.sizes = sizes;
  drawing.strands.points.clear();
  for (Eigen::Index at = 0; at < dense.size(); at += 3)
    drawing.strands.points.emplace_back(dense.segment<3>(at));
  return drawing;
}

// Returns the longest strand's length; 0 if there are no strands.
double longest(const particles::State& state, const std::vector<int>& strands) {
  double most = 0;
  Eigen::Index at = 0;
  for (const int points : strands) {
    double length = 0;
    for (int i = 1; i < points; ++i)
      length += (state.x.segment<3>(at + 3 * i) - state.x.segment<3>(at + 3 * i - 3)).norm();
    most = std::max(most, length);
    at += 3 * points;
  }
  return most;
}

// Collects the motion of one run for a page.
class Motion {
 public:
  Motion(const hair::Scene& scene, const hair::Camera& camera, std::size_t frames)
      : frames_(static_cast<int>(frames), hair::kMostPointsShipped) {
    story_.name = scene.name;
    story_.shows = scene.shows;
    story_.camera = camera;
    story_.series = {{"energy", "J"}, {"largest stretch", "%"}};
  }

  void add(const hair::Drawing& drawing, double time, const hair::FrameMeasures& measures) {
    frames_.add(drawing);
    story_.times.push_back(time);
    story_.series[0].values.push_back(measures.energy());
    story_.series[1].values.push_back(100 * measures.stretch);
  }
  std::string json(const char* broken) {
    story_.blow_up = broken;
    return frames_.json(story_);
  }

 private:
  hair::MotionFrames frames_;
  hair::MotionStory story_;
};

}  // namespace

RunComparison compare_runs(const hair::Scene& scene, const std::vector<int>& pictures, const Played& theirs) {
  RunComparison result;
  hair::SceneRun ours(scene);
  const std::vector<bool> held = held_points(scene, ours.strands());
  const hair::SceneDrawing drawing(scene, ours.strands());
  const bool with_dense_hair = !theirs.dense.empty();
  DenseStrands strands(scene, ours.strands());
  hair::Bounds bounds;
  std::vector<Taken> taken;
  for (int frame = 0; frame <= scene.frames; ++frame) {
    if (frame > 0)
      if (const auto trouble = ours.advance())
        throw std::logic_error("the reference breaks in " + scene.name + ": " + *trouble);
    const particles::State state = ours.state(), points = ours.centre_lines(state);
    for (std::size_t i = 0; i < held.size(); ++i)
      bounds.extend(points.x.segment<3>(3 * static_cast<Eigen::Index>(i)));
    const hair::FrameMeasures measures = ours.measure(state);
    result.kinetic = std::max(result.kinetic, measures.kinetic);

    if (static_cast<std::size_t>(frame) >= theirs.frames.size()) continue;
    const particles::State& their = theirs.frames[frame];
    Eigen::VectorXd our_dense, their_dense;
    if (with_dense_hair) {
      our_dense = strands.at(points.x, ours.time());
      their_dense = theirs.dense.at(frame);
    }
    result.finite = result.finite && is_finite(their) && their_dense.allFinite();
    if (!result.finite) continue;
    const particles::State their_points = ours.centre_lines(their);
    Moment moment{ours.time(), measures, ours.measure(their), 0, 0, 0};
    for (std::size_t i = 0; i < static_cast<std::size_t>(our_dense.size() / 3); ++i)
      moment.dense_apart = std::max(moment.dense_apart, distance(our_dense, their_dense, i));
    for (std::size_t i = 0; i < held.size(); ++i) {
      const double apart = distance(points.x, their_points.x, i);
      moment.apart = std::max(moment.apart, apart);
      if (held[i]) moment.held_apart = std::max(moment.held_apart, apart);
    }
    taken.push_back({frame, moment, points, their_points, our_dense, their_dense, ours.obstacles()});
    result.moments.push_back(moment);
  }
  result.size = bounds.sizes().norm();
  result.camera = camera_of(scene, drawing, bounds);

  const auto apart_of = [](const Taken& one) { return std::max(one.moment.apart, one.moment.dense_apart); };
  taken.erase(std::ranges::find_if(
                  taken, [&](const Taken& one) { return !(apart_of(one) <= kFarthestDrawn * result.size); }),
              taken.end());
  const double length = taken.empty() ? 0 : longest(taken.front().ours, ours.strands());
  const double whole = length > 0 ? length : result.size;
  const auto drawn = [&](const hair::SceneDrawing& by, const Taken& one, bool is_ours) {
    hair::Drawing plain = by.at(is_ours ? one.ours : one.theirs, one.obstacles, one.moment.time);
    const Eigen::VectorXd& dense = is_ours ? one.our_dense : one.their_dense;
    return with_dense_hair ? with_dense(std::move(plain), strands.sizes(), dense) : plain;
  };
  const auto looks_same = [&](const Taken& one) { return apart_of(one) <= kSameParticles * result.size; };
  const auto shot = [&](const Taken& one, bool is_last) {
    const double apart = apart_of(one);
    return Shot{name_at(one.moment.time),
                drawn(drawing, one, true),
                drawn(drawing, one, false),
                100 * apart / whole,
                looks_same(one),
                apart > kNear * result.size,
                is_last};
  };
  // The start shows only the scene.
  const bool is_cut =
      !pictures.empty() && taken.size() > 1 && static_cast<int>(taken.size()) <= pictures.back();
  for (const Taken& one : taken) {
    const bool is_last = is_cut && one.frame == taken.back().frame;
    if (is_last || std::ranges::find(pictures, one.frame) != pictures.end())
      result.shots.push_back(shot(one, is_last));
  }
  if (pictures.empty() || std::ranges::all_of(taken, looks_same)) return result;
  const hair::SceneDrawing for_pages(scene, ours.strands(), {}, hair::kCellsOfPage);
  Motion our_motion(scene, result.camera, taken.size()), their_motion(scene, result.camera, taken.size());
  for (const Taken& one : taken) {
    our_motion.add(drawn(for_pages, one, true), one.moment.time, one.moment.ours);
    their_motion.add(drawn(for_pages, one, false), one.moment.time, one.moment.theirs);
  }
  result.our_motion = our_motion.json("");
  result.their_motion = their_motion.json(is_cut ? "no later moment can be drawn" : "");
  const std::size_t shots = std::min(kFilmShots, taken.size());
  for (std::size_t i = 0; i < shots; ++i)
    result.film.push_back(shot(taken[i * (taken.size() - 1) / std::max<std::size_t>(shots - 1, 1)], false));
  return result;
}

}  // namespace grader::judge
