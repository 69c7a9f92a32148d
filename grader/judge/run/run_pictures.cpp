// STAFF ONLY. Draws the pictures of two runs and compares them.
#include "grader/judge/run/run_pictures.h"

#include <memory>

#include "grader/compare/compare.h"
#include "grader/compare/montage.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/write_file.h"
#include "hair/io/image/read_png.h"
#include "hair/render/opengl/renderer.h"

namespace grader::inline judge {
namespace {

namespace fs = std::filesystem;

// Loads OpenGL when a picture is drawn for the first time; stored pictures need none.
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

// Returns a file's bytes; makes the file if it does not exist.
template <class Make>
std::string made_once(const fs::path& file, const Make& make) {
  std::string bytes = hair::bytes_of(file);
  if (!bytes.empty()) return bytes;
  bytes = make();
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
    picture.far_off = shot.far_off;
    picture.breaks_off = shot.breaks_off;
    picture.apart = shot.apart;
    picture.reference = picture.student =
        made_once(kept / (shot.name + ".png"), [&] { return hair::encode_png(artist.draw(shot.reference)); });
    if (!shot.same) {
      const hair::Image reference = hair::decode_png(picture.reference, shot.name);
      const hair::Image student = artist.draw(shot.student);
      const ErrorMap map = flip(reference, student);
      const PictureDistance distance = compare_pictures(reference, student, map);
      picture.blurred_rmse = distance.blurred_rmse;
      picture.flip = distance.flip_mean;
      if (!distance.identical) {
        picture.student = hair::encode_png(student);
        // A map is smooth, so half its size is enough.
        picture.heat = hair::encode_png(shrunk(heat_map(map), kPictureWidth / 2));
      }
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

std::string draw_film(const std::vector<Shot>& shots, const hair::Camera& camera) {
  Artist artist(camera);
  hair::Image film;
  for (const Shot& shot : shots) {
    const hair::Image both = side_by_side(
        {shrunk(artist.draw(shot.student), kCoarseWidth), shrunk(artist.draw(shot.reference), kCoarseWidth)});
    film.width = both.width;
    film.height += both.height;
    film.pixels.insert(film.pixels.end(), both.pixels.begin(), both.pixels.end());
  }
  return hair::encode_png(film);
}

}  // namespace grader::judge
