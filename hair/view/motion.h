// A run's motion as pages show it: all that is drawn, frame by frame, in 16 bits a coordinate, and what was
// measured. motion.json is one object:
//
//   name, shows, ended  texts
//   blow_up             {"text", "strand"} (-1: none of them), or null
//   camera              {"eye", "target", "field_of_view", "aspect"}: m, m, rad of the picture's height, and width / height
//   times               s, one a frame
//   series              [{"name", "unit", "values"}]: one value a frame, null if it is not finite
//   low, high           m, the corners of a box
//   points              in each frame
//   strands             points of each that is shown, root to tip; of strands_in_all. They come first
//   width, root, tip    of strands: m; colours as screens take them, 0 to 1
//   first_rod, rods     balls, springs, limbs: [{"radius", "colour"}], two points each
//   sheets              cloth: [{"first", "rows", "columns", "colour"}], rows x columns points each
//   meshes              solids: [{"first", "reach", "points", "triangles", "colour"}], in their own frames; of the motion's points four each: where
//                       the solid's origin is, and the points that are `reach` along its axes
//   planes              [{"points", "normals"}]: three numbers a frame, or three in all if it rests
//   data                base64 of 3 x points whole numbers a frame, 16 bits each, the lowest byte first: 0 is the box's low side,
//                       65535 its high side
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace hair {

// More points in all frames together leave strands out: a page of at most 12 MB, 8 bytes a point and 0.8 MB
// for what else there is.
inline constexpr std::size_t kMostPointsShown = 1'400'000;

// The same of a run that comes along with the handout: half a megabyte at most.
inline constexpr std::size_t kMostPointsShipped = 40'000;

struct MotionSeries {
  std::string name, unit;
  std::vector<double> values = {};  // one a frame
};

struct MotionStory {
  std::string name, shows, ended, blow_up;
  int broken_strand = -1;
  Camera camera = {};
  double aspect = 16.0 / 9;        // of the picture that the camera is for
  std::vector<double> times = {};  // s
  std::vector<MotionSeries> series = {};
};

class MotionFrames {
 public:
  explicit MotionFrames(int frames, std::size_t most_points = kMostPointsShown)
      : frames_(frames), most_points_(most_points) {}

  // The first drawing says what there is; things that a later one lacks stay where they were, and new ones
  // are not shown. A point that is not finite stays, too.
  void add(const Drawing& drawing);

  // The strands of the first drawing that are not shown, by their ids; and how many it has.
  const std::vector<int>& unseen() const { return unseen_; }
  std::size_t strands_in_all() const { return strands_in_all_; }

  // A point's error is at most 1 / 131070 of the box, which is as large as all that was drawn, but for what
  // flew further than ten times the first frame's size: that is at its border.
  std::string json(const MotionStory& story) const;

  // The last frame alone, for a page that is open while it is computed: {"data", "planes"}, whose data are
  // base64 of 3 x points floats of 32 bits, m, the lowest byte first, and whose planes are as above. Call add
  // first.
  std::string last_json() const;
  void keep_last();  // frames before it are not kept

 private:
  void begin(const Drawing& drawing);
  void put(std::size_t point, const Vector3d& at);

  int frames_;
  std::size_t most_points_;
  std::size_t points_ = 0, first_rod_ = 0, strands_in_all_ = 0;
  std::map<std::uint32_t, std::size_t> first_point_;  // of each strand that is shown, by its id
  std::map<std::uint32_t, int> size_of_;
  std::vector<int> strands_, unseen_;
  std::vector<double> rod_radii_;
  std::vector<Colour> rod_colours_;
  StrandsDrawing look_;  // without strands
  std::vector<Sheet> sheets_;
  std::vector<PlacedMesh> meshes_;
  std::vector<std::vector<Plane>> planes_;  // of each frame
  std::vector<Eigen::Vector3f> all_;        // frame after frame
};

}  // namespace hair
