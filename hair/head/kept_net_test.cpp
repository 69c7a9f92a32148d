// STAFF ONLY. Kept surface nets: a net from a file equals the made one, and an incomplete file is ignored.
#include "hair/head/kept_net.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

constexpr int kCells = 20;

class KeptNet : public testing::Test {
 protected:
  KeptNet() { fs::remove_all(folder_); }
  ~KeptNet() override { fs::remove_all(folder_); }

  std::vector<fs::path> files() const {
    std::vector<fs::path> all;
    if (fs::exists(folder_))
      for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path());
    return all;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / "kept_net_test";
};

void expect_same(const SurfaceMesh& one, const SurfaceMesh& other) {
  EXPECT_EQ(one.points, other.points);
  EXPECT_EQ(one.normals, other.normals);
  EXPECT_EQ(one.triangles, other.triangles);
}

TEST_F(KeptNet, IsTheNetThatWasMade) {
  const SurfaceMesh made = surface_net(Bust(), kCells);
  expect_same(kept_surface_net(Bust(), kCells, folder_), made);
  ASSERT_EQ(files().size(), 1U);
  expect_same(kept_surface_net(Bust(), kCells, folder_), made);
  EXPECT_EQ(files().size(), 1U);
  expect_same(kept_surface_net(Bust(), kCells, {}), made);
}

TEST_F(KeptNet, BelongsToItsSolidAndItsCells) {
  kept_surface_net(Bust(), kCells, folder_);
  expect_same(kept_surface_net(EllipsoidHead(), kCells, folder_), surface_net(EllipsoidHead(), kCells));
  expect_same(kept_surface_net(Bust(), kCells + 1, folder_), surface_net(Bust(), kCells + 1));
  EXPECT_EQ(files().size(), 3U);
}

TEST_F(KeptNet, IsMadeAgainIfItsFileIsNotWhole) {
  const SurfaceMesh made = kept_surface_net(Bust(), kCells, folder_);
  const fs::path file = files().at(0);
  const auto size = fs::file_size(file);
  fs::resize_file(file, size - 100);
  expect_same(kept_surface_net(Bust(), kCells, folder_), made);
  EXPECT_EQ(fs::file_size(file), size);
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(200).put('x');
  expect_same(kept_surface_net(Bust(), kCells, folder_), made);
}

TEST_F(KeptNet, IsMadeWhereNothingCanBeKept) {
  std::ofstream(folder_) << "a file, and no folder";
  expect_same(kept_surface_net(Bust(), kCells, folder_), surface_net(Bust(), kCells));
}

}  // namespace
}  // namespace hair
