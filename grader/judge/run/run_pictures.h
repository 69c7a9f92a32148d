// STAFF ONLY. Pictures of two runs of a scene, the submission's and the reference's, and their distance. The
// reference's pictures are the same for a class: they are drawn once and stored.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/result/result.h"
#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace grader::inline judge {

// Pixels. Small, because there are many pictures; a strand is about 3 pixels wide.
inline constexpr int kPictureWidth = 480, kPictureHeight = 270;

// Holds a moment of both runs.
struct Shot {
  std::string name;  // "0.50 s"
  hair::Drawing reference, student;
  double apart = 0;   // is PictureResult::apart
  bool same = false;  // True: the particles look the same, so both share one picture.
  bool far_off = false;
  bool breaks_off = false;
};

// `kept` is the folder with the reference's stored pictures of this run. Throws hair::NoOpenGl.
std::vector<PictureResult> draw_shots(const std::vector<Shot>& shots, const hair::Camera& camera,
                                      const std::filesystem::path& kept);

// Draws a film for students: a PNG file whose rows are moments, the submission's to the left of the
// reference's, as coarse as they may see what is far off (kCoarseWidth). Throws hair::NoOpenGl.
std::string draw_film(const std::vector<Shot>& shots, const hair::Camera& camera);

}  // namespace grader::judge
