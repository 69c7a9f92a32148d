#include "hair/head/surface_net.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/head/kept_net.h"
#include "hair/io/files/temporary_folder.h"

namespace hair {
namespace {

// Each edge, from its lower to its higher point, with the number of triangles along it in either direction.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<int, 2>> edges_of(const SurfaceMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<int, 2>> edges;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      ++edges[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1];
    }
  return edges;
}

class Nets : public testing::TestWithParam<int> {};

TEST_P(Nets, AreClosedOrientedAndOnTheSurface) {
  const Bust bust;
  const EllipsoidHead ellipsoid;
  for (const Solid* const solid : {static_cast<const Solid*>(&bust), static_cast<const Solid*>(&ellipsoid)}) {
    const SurfaceMesh mesh = surface_net(*solid, GetParam());
    const auto edges = edges_of(mesh);
    for (const auto& [edge, ways] : edges) ASSERT_EQ(ways, (std::array<int, 2>{1, 1})) << edge.first;
    // Euler's number is a ball's.
    EXPECT_EQ(static_cast<long>(mesh.points.size()) - static_cast<long>(edges.size()) +
                  static_cast<long>(mesh.triangles.size()),
              2);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const Surface here = solid->surface_at(mesh.points[i]);
      ASSERT_NEAR(here.distance, 0, 1e-6) << mesh.points[i].transpose();
      ASSERT_EQ(here.normal, mesh.normals[i]);
    }
    const double width = solid->box().sizes().maxCoeff() / GetParam();
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vector3d area = 0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
      // Triangles are not degenerate, and anticlockwise as seen from outside.
      EXPECT_GT(area.norm(), 1e-4 * width * width) << mesh.points[a].transpose();
      EXPECT_GT(area.dot(mesh.normals[a] + mesh.normals[b] + mesh.normals[c]), 0)
          << mesh.points[a].transpose();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, Nets, testing::Values(66, 100));

double volume_of(const SurfaceMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c])) / 6;
  return volume;
}

// Chords are inside by the square of their length: with twice the cells, the error is a quarter.
TEST(SurfaceNet, TheVolumeIsRightToSecondOrder) {
  const double volume = 4 * M_PI / 3 * 0.076 * 0.096 * 0.112;
  const EllipsoidHead head;
  const double coarse = volume - volume_of(surface_net(head, 20)),
               fine = volume - volume_of(surface_net(head, 40));
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, 0.01 * volume);
  EXPECT_NEAR(coarse / fine, 4, 0.5);
}

TEST(SurfaceNet, IsTheSameEachTime) {
  const Bust bust;
  const SurfaceMesh one = surface_net(bust, 40), other = surface_net(bust, 40);
  EXPECT_EQ(one.points, other.points);
  EXPECT_EQ(one.triangles, other.triangles);
  EXPECT_THROW(surface_net(bust, 3), std::invalid_argument);
  EXPECT_THROW(surface_net(bust, 1001), std::invalid_argument);
}

// --- Kept nets: a net from a file equals the made one, and an incomplete file is ignored.

namespace fs = std::filesystem;

void expect_same(const SurfaceMesh& one, const SurfaceMesh& other) {
  EXPECT_EQ(one.points, other.points);
  EXPECT_EQ(one.normals, other.normals);
  EXPECT_EQ(one.triangles, other.triangles);
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
  return all;
}

TEST(KeptNet, BelongsToItsSolidAndItsCellsAndIsMadeAgainIfItsFileIsNotWhole) {
  const TemporaryFolder temporary("kept-net");
  const fs::path folder = temporary.path() / "nets";
  const SurfaceMesh bust = surface_net(Bust(), 20);
  expect_same(kept_surface_net(Bust(), 20, folder), bust);
  ASSERT_EQ(files_in(folder).size(), 1U);
  const fs::path file = files_in(folder).at(0);
  expect_same(kept_surface_net(Bust(), 20, folder), bust);
  EXPECT_EQ(files_in(folder).size(), 1U);
  expect_same(kept_surface_net(Bust(), 20, {}), bust);

  expect_same(kept_surface_net(EllipsoidHead(), 20, folder), surface_net(EllipsoidHead(), 20));
  expect_same(kept_surface_net(Bust(), 21, folder), surface_net(Bust(), 21));
  EXPECT_EQ(files_in(folder).size(), 3U);

  const auto size = fs::file_size(file);
  fs::resize_file(file, size - 100);
  expect_same(kept_surface_net(Bust(), 20, folder), bust);
  EXPECT_EQ(fs::file_size(file), size);
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(200).put('x');
  expect_same(kept_surface_net(Bust(), 20, folder), bust);
  expect_same(kept_surface_net(Bust(), 20, file), bust);  // in a file nothing can be kept
}

}  // namespace
}  // namespace hair
