// STAFF ONLY. Pictures of two runs of a scene, the submission's and the reference's, and how far apart they
// are. The reference's are the same for a class: they are drawn once, and kept.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "grader/report/result.h"
#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace grader {

// Pixels. Small, for there are many; a strand is some 3 of them wide.
inline constexpr int kPictureWidth = 480, kPictureHeight = 270;
// Of what pages show, so that a submission of which nothing is right takes less than 1 MB with all pictures.
inline constexpr std::size_t kPictureColors = 96, kMapColors = 32;

// A moment of both runs.
struct Shot {
  std::string name;  // "0.50 s"
  hair::Drawing reference, student;
  bool same = false;  // whose particles nobody could tell apart: one picture does for both
};

// `kept` is the folder in which the reference's pictures of this run are kept. Throws hair::NoOpenGl.
std::vector<PictureResult> draw_shots(const std::vector<Shot>& shots, const hair::Camera& camera,
                                      const std::filesystem::path& kept);

}  // namespace grader
