// STAFF ONLY. The cameras of the shipped scenes: they have all hair in the picture, in each frame, and are no
// farther away than necessary. The runs are the reference's that ship with them (target hair_motions).
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "hair/io/files/read_file.h"
#include "hair/render/view.h"
#include "hair/view/test_motion.h"

namespace hair {
namespace {

using Json = nlohmann::json;

Vector3d vector_of(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

// The picture goes from -1 to 1 in both directions.
struct Covered {
  Eigen::AlignedBox2d box;
  double size() const { return box.isEmpty() ? 0 : box.sizes().maxCoeff() / 2; }  // parts of the picture
};

class Shown {
 public:
  explicit Shown(const Json& motion) : motion_(motion), bytes_(bytes_of_base64(motion["data"])) {
    const Json& camera = motion["camera"];
    eye_ = vector_of(camera["eye"]);
    const Vector3d back = (eye_ - vector_of(camera["target"])).normalized();
    axes_ = view_axes(back, Vector3d::UnitZ());
    tangent_ = std::tan(camera["field_of_view"].get<double>() / 2);
    for (const Json& size : motion["strands"]) points_ += size.get<std::size_t>();
    if (points_ == 0) points_ = motion["points"];  // a toy
  }

  std::size_t frames() const { return motion_["times"].size(); }

  Covered at(std::size_t frame) const {
    Covered covered;
    const double aspect = motion_["camera"]["aspect"];
    for (std::size_t i = 0; i < points_; ++i) {
      const Vector3d seen = axes_ * (point_of(motion_, bytes_, frame, i) - eye_);
      covered.box.extend(Eigen::Vector2d(seen.x() / aspect, seen.y()) / (-seen.z() * tangent_));
    }
    return covered;
  }

 private:
  const Json& motion_;
  std::string bytes_;
  std::size_t points_ = 0;
  Vector3d eye_;
  Eigen::Matrix3d axes_;
  double tangent_;
};

// A head takes the rest of the picture, so hair alone fills less.
constexpr double kLeastOfRun = 0.5, kLeastOfFrame = 0.15, kLeastWithHead = 0.3;

TEST(Framing, HasAllHairInThePictureAndFillsIt) {
  std::printf("| scene | whole run | first | middle | last |\n|---|--:|--:|--:|--:|\n");
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HAIR_MOTIONS_DIR)) {
    const Json motion = Json::parse(bytes_of(entry.path()));
    const std::string name = motion["name"];
    const Shown shown(motion);
    Covered whole;
    for (std::size_t k = 0; k < shown.frames(); ++k) whole.box.extend(shown.at(k).box);
    const double least = motion["meshes"].empty() ? kLeastOfRun : kLeastWithHead;
    EXPECT_GE(whole.size(), least) << name << " fills less of its picture";
    EXPECT_LE(whole.box.max().maxCoeff(), 1) << name << " leaves the picture";
    EXPECT_GE(whole.box.min().minCoeff(), -1) << name << " leaves the picture";
    std::printf("| `%s` | %.2f |", name.c_str(), whole.size());
    for (const std::size_t k : {std::size_t{0}, shown.frames() / 2, shown.frames() - 1}) {
      const double size = shown.at(k).size();
      EXPECT_GE(size, kLeastOfFrame) << name << ", frame " << k;
      std::printf(" %.2f |", size);
    }
    std::printf("\n");
    ++scenes;
  }
  EXPECT_GT(scenes, 20);
}

}  // namespace
}  // namespace hair
