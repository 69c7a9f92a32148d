#include "hair/view/motion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "hair/io/files/base64.h"
#include "hair/io/files/json_text.h"
#include "hair/io/plot/page.h"

namespace hair {

namespace {

constexpr int kRodsOfRing = 24, kPointsOfPose = 4;
const Colour kObstacle(0.30f, 0.31f, 0.34f);  // linear
constexpr double kFarthest = 10;              // first frames' sizes

struct Rod {
  Vector3d a, b;
  double radius;
  Colour colour;
};

std::vector<Rod> rods_of(const Drawing& drawing) {
  std::vector<Rod> rods;
  for (const Tube& tube : drawing.tubes) rods.push_back({tube.a, tube.b, tube.radius, tube.colour});
  for (const Ball& ball : drawing.balls) rods.push_back({ball.centre, ball.centre, ball.radius, ball.colour});
  for (const Ring& ring : drawing.rings) {
    const Vector3d x = ring.normal.unitOrthogonal(), y = ring.normal.cross(x);
    const auto at = [&](int i) -> Vector3d {
      const double angle = 2 * std::numbers::pi * i / kRodsOfRing;
      return ring.centre + ring.radius * (std::cos(angle) * x + std::sin(angle) * y);
    };
    for (int i = 0; i < kRodsOfRing; ++i) rods.push_back({at(i), at(i + 1), ring.thickness, ring.colour});
  }
  for (const Obstacle& obstacle : drawing.obstacles) {
    if (const auto* sphere = std::get_if<Sphere>(&obstacle.shape))
      rods.push_back({sphere->centre, sphere->centre, sphere->radius, kObstacle});
    if (const auto* capsule = std::get_if<Capsule>(&obstacle.shape))
      rods.push_back({capsule->a, capsule->b, capsule->radius, kObstacle});
  }
  return rods;
}

std::vector<Plane> planes_of(const Drawing& drawing) {
  std::vector<Plane> planes;
  for (const Obstacle& obstacle : drawing.obstacles)
    if (const auto* plane = std::get_if<Plane>(&obstacle.shape)) planes.push_back(*plane);
  return planes;
}

double reach_of(const SurfaceMesh& mesh) {
  double reach = 0;
  for (const Vector3d& point : mesh.points) reach = std::max(reach, point.norm());
  return reach > 0 ? reach : 1;
}

std::string few_digits(double value) {
  return std::isfinite(value) ? printed("%.6g", value) : "null";
}

template <class List, class Text>
std::string list_of(const List& list, const Text& text_of) {
  std::string text = "[";
  for (const auto& one : list) text += (text.size() > 1 ? "," : "") + text_of(one);
  return text + "]";
}

std::string exact_vector_text(const Vector3d& v) {
  return json_list({json_text(v.x()), json_text(v.y()), json_text(v.z())});
}

std::string vector_text(const Vector3d& v) {
  return json_list({few_digits(v.x()), few_digits(v.y()), few_digits(v.z())});
}

// As exact as the bounded numbers.
std::string corner_text(const Eigen::Vector3f& corner) {
  return list_of(corner, [](float x) { return printed("%.9g", static_cast<double>(x)); });
}

// Screens expect linear light to the power of 1 / 2.2.
std::string colour_text(const Colour& linear) {
  return vector_text(linear.cast<double>().array().max(0.0).min(1.0).pow(1 / 2.2).matrix());
}

std::string numbers_text(const std::vector<double>& numbers) {
  return list_of(numbers, few_digits);
}

struct Box {
  Eigen::Vector3f low, high;
};

Box box_of(const std::vector<Eigen::Vector3f>& all, std::size_t points) {
  Box first{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  if (points == 0) return first;
  first = {all[0], all[0]};
  for (std::size_t i = 1; i < points; ++i) first = {first.low.cwiseMin(all[i]), first.high.cwiseMax(all[i])};
  const Eigen::Vector3f middle = (first.low + first.high) / 2;
  const float farthest = static_cast<float>(kFarthest) * (first.high - first.low).norm();
  Box box = first;
  for (const Eigen::Vector3f& point : all) {
    const Eigen::Vector3f kept = middle + (point - middle).cwiseMax(-farthest).cwiseMin(farthest);
    box = {box.low.cwiseMin(kept), box.high.cwiseMax(kept)};
  }
  return box;
}

std::string quantised(const std::vector<Eigen::Vector3f>& all, const Box& box) {
  constexpr double kSteps = 65535;
  std::string bytes;
  bytes.reserve(6 * all.size());
  for (const Eigen::Vector3f& point : all)
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box.low[axis], size = static_cast<double>(box.high[axis]) - low;
      const double part = size > 0 ? (static_cast<double>(point[axis]) - low) / size : 0;
      const auto step = static_cast<unsigned>(std::lround(kSteps * std::clamp(part, 0.0, 1.0)));
      bytes += static_cast<char>(step & 255U);
      bytes += static_cast<char>(step >> 8);
    }
  return bytes;
}

}  // namespace

void MotionFrames::begin(const Drawing& drawing) {
  const StrandsDrawing& hair = drawing.strands;
  look_.width = hair.width;
  look_.root = hair.root;
  look_.tip = hair.tip;
  strands_in_all_ = hair.sizes.size();
  const std::size_t wanted = hair.points.size() * static_cast<std::size_t>(std::max(1, frames_));
  const std::size_t every = std::max<std::size_t>(1, (wanted + most_points_ - 1) / most_points_);
  for (std::size_t s = 0; s < hair.sizes.size(); ++s) {
    const std::uint32_t id = hair.id(s);
    if (s % every != 0) {
      unseen_.push_back(static_cast<int>(id));
      continue;
    }
    first_point_[id] = points_;
    size_of_[id] = hair.sizes[s];
    strands_.push_back(hair.sizes[s]);
    points_ += static_cast<std::size_t>(hair.sizes[s]);
  }
  first_rod_ = points_;
  for (const Rod& rod : rods_of(drawing)) {
    rod_radii_.push_back(rod.radius);
    rod_colours_.push_back(rod.colour);
    points_ += 2;
  }
  sheets_ = drawing.sheets;
  for (const Sheet& sheet : sheets_) points_ += sheet.points.size();
  meshes_ = drawing.meshes;
  points_ += kPointsOfPose * meshes_.size();
}

void MotionFrames::put(std::size_t point, const Vector3d& at) {
  if (at.allFinite()) all_[all_.size() - points_ + point] = at.cast<float>();
}

void MotionFrames::add(const Drawing& drawing) {
  const bool first = planes_.empty();
  if (first) begin(drawing);
  planes_.push_back(planes_of(drawing));
  const std::size_t before = all_.size();
  all_.resize(before + points_, Eigen::Vector3f::Zero());
  if (!first)
    std::copy(all_.begin() + static_cast<std::ptrdiff_t>(before - points_),
              all_.begin() + static_cast<std::ptrdiff_t>(before),
              all_.begin() + static_cast<std::ptrdiff_t>(before));

  const StrandsDrawing& hair = drawing.strands;
  std::size_t from = 0;
  for (std::size_t s = 0; s < hair.sizes.size(); from += static_cast<std::size_t>(hair.sizes[s]), ++s) {
    const std::uint32_t id = hair.id(s);
    const auto to = first_point_.find(id);
    if (to == first_point_.end() || size_of_.at(id) != hair.sizes[s]) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(hair.sizes[s]); ++i)
      put(to->second + i, hair.points[from + i]);
  }
  const std::vector<Rod> rods = rods_of(drawing);
  for (std::size_t i = 0; i < std::min(rods.size(), rod_radii_.size()); ++i) {
    put(first_rod_ + 2 * i, rods[i].a);
    put(first_rod_ + 2 * i + 1, rods[i].b);
  }
  std::size_t point = first_rod_ + 2 * rod_radii_.size();
  for (std::size_t i = 0; i < sheets_.size(); ++i)
    for (std::size_t k = 0; k < sheets_[i].points.size(); ++k, ++point)
      if (i < drawing.sheets.size() && k < drawing.sheets[i].points.size())
        put(point, drawing.sheets[i].points[k]);
  for (std::size_t i = 0; i < meshes_.size(); ++i, point += kPointsOfPose) {
    if (i >= drawing.meshes.size()) continue;
    const PlacedMesh& mesh = drawing.meshes[i];
    put(point, mesh.at);
    for (int axis = 0; axis < 3; ++axis)
      put(point + 1 + static_cast<std::size_t>(axis),
          mesh.at + mesh.rotation * (reach_of(*meshes_[i].mesh) * Vector3d::Unit(axis)));
  }
}

std::string MotionFrames::json(const MotionStory& story) const {
  const Box box = box_of(all_, points_);
  std::vector<std::string> rods, sheets, meshes, planes;
  for (std::size_t i = 0; i < rod_radii_.size(); ++i)
    rods.push_back(
        json_object({{"radius", few_digits(rod_radii_[i])}, {"colour", colour_text(rod_colours_[i])}}));
  std::size_t point = first_rod_ + 2 * rod_radii_.size();
  for (const Sheet& sheet : sheets_) {
    sheets.push_back(json_object({{"first", json_text(static_cast<long>(point))},
                                  {"rows", json_text(sheet.rows)},
                                  {"columns", json_text(sheet.columns)},
                                  {"colour", colour_text(sheet.colour)}}));
    point += sheet.points.size();
  }
  for (const PlacedMesh& placed : meshes_) {
    std::vector<double> corners;
    for (const Vector3d& corner : placed.mesh->points)
      corners.insert(corners.end(), corner.begin(), corner.end());
    std::string triangles = "[";
    for (const auto& triangle : placed.mesh->triangles)
      for (const std::uint32_t corner : triangle)
        triangles += (triangles.size() > 1 ? "," : "") + std::to_string(corner);
    meshes.push_back(json_object({{"first", json_text(static_cast<long>(point))},
                                  {"reach", json_text(reach_of(*placed.mesh))},
                                  {"points", list_of(corners, [](double x) { return printed("%.4g", x); })},
                                  {"triangles", triangles + "]"},
                                  {"colour", colour_text(kObstacle)}}));
    point += kPointsOfPose;
  }
  for (std::size_t i = 0; i < (planes_.empty() ? 0 : planes_.front().size()); ++i) {
    std::vector<double> points, normals;
    bool rests = true;
    for (const std::vector<Plane>& frame : planes_) {
      const Plane& plane = frame.at(i);
      rests = rests && plane.point == planes_.front()[i].point && plane.normal == planes_.front()[i].normal;
      points.insert(points.end(), plane.point.begin(), plane.point.end());
      normals.insert(normals.end(), plane.normal.begin(), plane.normal.end());
    }
    if (rests) {
      points.resize(3);
      normals.resize(3);
    }
    planes.push_back(json_object({{"points", numbers_text(points)}, {"normals", numbers_text(normals)}}));
  }
  const auto as_it_is = [](const std::string& text) { return text; };
  const std::string blow_up =
      story.blow_up.empty()
          ? "null"
          : json_object({{"text", json_text(story.blow_up)}, {"strand", json_text(story.broken_strand)}});
  return json_object({{"name", json_text(story.name)},
                      {"shows", json_text(story.shows)},
                      {"ended", json_text(story.ended)},
                      {"blow_up", blow_up},
                      {"camera", json_object({{"eye", vector_text(story.camera.eye)},
                                              {"target", vector_text(story.camera.target)},
                                              {"field_of_view", few_digits(story.camera.field_of_view)},
                                              {"aspect", few_digits(story.aspect)}})},
                      {"times", list_of(story.times, [](double time) { return json_text(time); })},
                      {"series", list_of(story.series,
                                         [](const MotionSeries& one) {
                                           return json_object({{"name", json_text(one.name)},
                                                               {"unit", json_text(one.unit)},
                                                               {"values", numbers_text(one.values)}});
                                         })},
                      {"low", corner_text(box.low)},
                      {"high", corner_text(box.high)},
                      {"points", json_text(static_cast<long>(points_))},
                      {"strands", list_of(strands_, [](int size) { return std::to_string(size); })},
                      {"strands_in_all", json_text(static_cast<long>(strands_in_all_))},
                      {"width", few_digits(look_.width)},
                      {"root", colour_text(look_.root)},
                      {"tip", colour_text(look_.tip)},
                      {"first_rod", json_text(static_cast<long>(first_rod_))},
                      {"rods", list_of(rods, as_it_is)},
                      {"sheets", list_of(sheets, as_it_is)},
                      {"meshes", list_of(meshes, as_it_is)},
                      {"planes", list_of(planes, as_it_is)},
                      {"data", json_text(base64(quantised(all_, box)))}}) +
         "\n";
}

std::string MotionFrames::last_json() const {
  std::string bytes;
  bytes.reserve(12 * points_);
  for (std::size_t i = all_.size() - points_; i < all_.size(); ++i)
    for (const float x : all_[i])
      for (int byte = 0; byte < 4; ++byte)
        bytes += static_cast<char>(std::bit_cast<std::uint32_t>(x) >> (8 * byte) & 255U);
  const std::string planes = list_of(planes_.back(), [](const Plane& plane) {
    return json_object(
        {{"points", exact_vector_text(plane.point)}, {"normals", exact_vector_text(plane.normal)}});
  });
  return json_object({{"data", json_text(base64(bytes))}, {"planes", planes}});
}

void MotionFrames::keep_last() {
  all_.erase(all_.begin(), all_.end() - static_cast<std::ptrdiff_t>(points_));
  planes_.erase(planes_.begin(), planes_.end() - 1);
}

}  // namespace hair
