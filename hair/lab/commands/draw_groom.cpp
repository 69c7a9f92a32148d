#include "hair/lab/commands/draw_groom.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <utility>

#include "hair/groom/groom_file.h"
#include "hair/groom/groom_measures.h"
#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/head/hair_colours.h"
#include "hair/head/kept_net.h"
#include "hair/head/scalp_roots.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/cache_folder.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/write_file.h"
#include "hair/io/image/png.h"
#include "hair/lab/commands/groom_info.h"
#include "hair/render/opengl/renderer.h"
#include "hair/render/strand_clearance.h"

namespace hair {
namespace {

constexpr int kScalpSamples = 500, kMostFitted = 2000, kFitRounds = 30, kHeadCells = 220;

// A head has a hundred thousand hairs of 80 micrometres. Fewer strands are drawn wider, so that they cover it
// as well, but no wider than hair can look.
double width_for(std::size_t strands) {
  return std::clamp(8e-5 * 1e5 / static_cast<double>(strands), 8e-5, 4e-4);
}

Eigen::AlignedBox3d box_of(const std::vector<Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : points) box.extend(point);
  return box;
}

std::shared_ptr<const Head> head_named(const std::string& name) {
  if (name == "bust") return std::make_shared<Bust>();
  if (name == "ellipsoid") return std::make_shared<EllipsoidHead>();
  return nullptr;
}

const HairColour& colour_named(const std::string& name) {
  const auto* const found = std::find_if(kHairColours.begin(), kHairColours.end(),
                                         [&](const HairColour& one) { return one.name == name; });
  if (found != kHairColours.end()) return *found;
  std::string known;
  for (const HairColour& one : kHairColours) known += (known.empty() ? "" : ", ") + std::string(one.name);
  throw BadInput("--colour: there is no colour \"" + printable(name) + "\"; there are " + known);
}

Colour linear(const std::array<double, 3>& parts) {
  return Eigen::Vector3d(parts[0], parts[1], parts[2]).cast<float>();
}

}  // namespace

GroomFit fit_to_head(const std::vector<Vector3d>& roots, const Head& head, std::optional<double> unit) {
  const Eigen::AlignedBox3d from = box_of(roots);
  const double size = roots.empty() ? 0 : from.diagonal().norm();
  if (roots.size() < 4 || !(size > 0))
    throw std::invalid_argument("a head needs at least 4 roots that are not in one place");
  std::vector<Vector3d> scalp;
  for (const RootFrame& root : scalp_roots(head, kScalpSamples, 0)) scalp.push_back(root.position);
  const Eigen::AlignedBox3d to = box_of(scalp);
  GroomFit fit;
  // Scalps end at different heights; their width and depth are comparable.
  fit.scale =
      unit.value_or(to.diagonal().head<2>().norm() / std::max(from.diagonal().head<2>().norm(), 1e-6 * size));
  fit.move = to.center() - fit.scale * from.center();
  fit.move[2] = to.max()[2] - fit.scale * from.max()[2];

  // Gauss and Newton: the distance's derivative is the normal. Unknowns are the move, and the scale about the
  // roots' middle.
  const std::size_t stride = (roots.size() + kMostFitted - 1) / kMostFitted;
  for (int round = 0; round < kFitRounds; ++round) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < roots.size(); i += stride) {
      const Surface surface = head.surface_at(fit.scale * roots[i] + fit.move);
      Eigen::Vector4d row;
      row << surface.normal, unit ? 0 : surface.normal.dot(roots[i] - from.center()) / size;
      normal += row * row.transpose();
      right -= row * surface.distance;
    }
    // A little damping fixes unknowns that the roots don't determine.
    normal.diagonal().array() += 1e-3 * normal.trace();
    const Eigen::Vector4d step = normal.ldlt().solve(right);
    const double grow = unit ? 0 : step[3] / size;
    fit.scale += grow;
    fit.move += step.head<3>() - grow * from.center();
  }
  return fit;
}

int draw_groom(const DrawOptions& options) {
  // The command line refuses all other values that are out of bounds.
  for (const auto& [option, number] : {std::pair("--unit", options.unit), std::pair("--width", options.width),
                                       std::pair("--turn", options.turn), std::pair("--zoom", options.zoom)})
    if (!std::isfinite(number)) throw BadInput(std::string(option) + ": is not a number; give one");
  const HairColour& colour = colour_named(options.colour);
  check_folder_of(options.picture);
  Groom groom = read_groom(options.file);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(options.turn * std::numbers::pi / 180, Vector3d::UnitZ()).toRotationMatrix();
  for (Eigen::VectorXd& strand : groom.strands)
    for (Eigen::Index i = 0; options.turn != 0 && i < points_of(strand); ++i)
      strand.segment<3>(3 * i) = (turn * strand.segment<3>(3 * i)).eval();
  std::vector<Vector3d> roots;
  for (const Eigen::VectorXd& strand : groom.strands)
    if (points_of(strand) > 1) roots.emplace_back(strand.head<3>());
  if (roots.empty())
    throw BadInput(printable(options.file.string(), 4096) + ": has no strand of two points or more to draw");

  const std::shared_ptr<const Head> head = head_named(options.on);
  const std::optional<double> unit = options.unit > 0 ? std::optional(options.unit) : std::nullopt;
  GroomFit fit;
  try {
    if (head)
      fit = fit_to_head(roots, *head, unit);
    else if (const double guess = measure_groom(groom).unit_guess; unit || guess > 0)
      fit.scale = unit.value_or(guess);
  } catch (const std::invalid_argument& error) {
    throw BadInput(printable(options.file.string(), 4096) + ": " + error.what() +
                   "; --on none draws it alone");
  }

  Drawing drawing;
  StrandsDrawing& strands = drawing.strands;
  strands.fine = true;
  strands.width = options.width > 0 ? options.width : width_for(roots.size());
  strands.root = linear(colour.root);
  strands.tip = linear(colour.tip);
  for (const Eigen::VectorXd& strand : groom.strands) {
    strands.sizes.push_back(static_cast<int>(points_of(strand)));
    for (Eigen::Index i = 0; i < points_of(strand); ++i)
      strands.points.emplace_back(fit.scale * strand.segment<3>(3 * i) + fit.move);
  }
  groom = {};
  if (head) {
    const std::vector<Obstacle> obstacles = {{PlacedSolid{head}}};
    StrandClearance(obstacles, threads_for(0)).move_out(obstacles, strands, 0, 0);
  }
  std::vector<Vector3d> seen = strands.points;
  if (head) {
    auto mesh = std::make_shared<SurfaceMesh>(kept_surface_net(*head, kHeadCells, cache_folder()));
    seen.insert(seen.end(), mesh->points.begin(), mesh->points.end());
    drawing.meshes.push_back({mesh, Vector3d::Zero(), Eigen::Quaterniond::Identity()});
  }
  const auto [width, height] = options.size;
  try {
    Renderer renderer({.width = width, .height = height, .shadows = !options.no_shadows});
    Camera camera = frame_points(seen, static_cast<double>(width) / height,
                                 Vector3d(options.view[0], options.view[1], options.view[2]));
    camera.eye = camera.target + (camera.eye - camera.target) / options.zoom;
    write_png(options.picture, renderer.draw(drawing, camera));
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  }
  std::cout << printable(options.picture.string(), 4096) << ": "
            << counted_with_groups(static_cast<long>(roots.size()), "strand") << ", a unit of " << fit.scale
            << " m, " << 1e3 * strands.width << " mm wide\n";
  return 0;
}

}  // namespace hair
