// STAFF ONLY.
#include "grader/suite/run_pictures.h"

#include <fstream>
#include <iterator>
#include <memory>

#include "grader/compare/compare.h"
#include "grader/compare/heat_map.h"
#include "hair/files/write_file.h"
#include "hair/image/png.h"
#include "hair/render/renderer.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

// Loads OpenGL when it is first needed, and not if all that is needed has been drawn before.
class Artist {
 public:
  explicit Artist(const hair::Camera& camera) : camera_(camera) {}

  hair::Image draw(const hair::Drawing& drawing) {
    if (!renderer_) {
      hair::RenderSettings settings;
      settings.width = kPictureWidth;
      settings.height = kPictureHeight;
      settings.shadows = false;
      renderer_ = std::make_unique<hair::Renderer>(settings);
    }
    return renderer_->draw(drawing, camera_);
  }

 private:
  const hair::Camera& camera_;
  std::unique_ptr<hair::Renderer> renderer_;
};

std::string read_bytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// As a PNG file's bytes.
std::string drawn_once(Artist& artist, const hair::Drawing& drawing, const fs::path& file) {
  std::string bytes = read_bytes(file);
  if (!bytes.empty()) return bytes;
  bytes = hair::encode_png(artist.draw(drawing));
  hair::write_file(file, bytes);
  return bytes;
}

}  // namespace

std::vector<PictureResult> draw_shots(const std::vector<Shot>& shots, const hair::Camera& camera,
                                      const fs::path& kept) {
  std::vector<PictureResult> pictures;
  Artist artist(camera);
  for (const Shot& shot : shots) {
    PictureResult picture;
    picture.name = shot.name;
    picture.reference = picture.student = drawn_once(artist, shot.reference, kept / (shot.name + ".png"));
    if (!shot.same) {
      const hair::Image reference = hair::decode_png(picture.reference, shot.name);
      const hair::Image student = artist.draw(shot.student);
      const ErrorMap map = flip(reference, student);
      const PictureDistance distance = compare_pictures(reference, student, map);
      picture.blurred_rmse = distance.blurred_rmse;
      picture.flip = distance.flip_mean;
      if (!distance.identical) {
        picture.student = hair::encode_png(student);
        picture.heat = hair::encode_png(heat_map(map));
      }
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace grader
