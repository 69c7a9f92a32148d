// A run's motion for pages: everything that is drawn, frame by frame, in 16 bits a coordinate, and the
// measured values. motion.json is one object:
//
//   name, shows, ended  texts
//   blow_up             {"text", "strand"} (-1: none of them), or null
//   camera              {"eye", "target", "field_of_view", "aspect"}: m, m, rad of the height, width / height
//   times               s, one a frame
//   series              [{"name", "unit", "values"}]: one value a frame, null if it is not finite
//   low, high           m, the corners of a box
//   points              in each frame
//   strands             points of each shown strand, root to tip; of strands_in_all. They come first
//   width, root, tip    for strands: m; colours of screens, 0 to 1
//   first_rod, rods     balls, springs, limbs: [{"radius", "colour"}], two points each
//   sheets              cloth: [{"first", "rows", "columns", "colour"}], rows x columns points each
//   meshes              solids: [{"first", "reach", "points", "triangles", "colour"}], in their own frames;
//   each
//                       has four of the motion's points: its origin, and those at `reach` along its axes
//   planes              [{"points", "normals"}]: three numbers a frame, or three in all if it rests
//   data                base64 of 3 x points whole numbers a frame, 16 bits each, the lowest byte first: 0 is
//                       the box's low side, 65535 its high side
//                       65535 its high side
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace hair {

// If all frames together have more points, strands are left out: a page has at most 12 MB, 8 bytes a point
// and 0.8 MB for the rest.
inline constexpr std::size_t kMostPointsShown = 1'400'000;

// The same for a run that the handout contains: half a megabyte at most.
inline constexpr std::size_t kMostPointsShipped = 40'000;

struct MotionSeries {
  std::string name, unit;
  std::vector<double> values = {};  // one a frame
};

struct MotionStory {
  std::string name, shows, ended, blow_up;
  int broken_strand = -1;
  Camera camera = {};
  double aspect = 16.0 / 9;        // width / height of the camera's picture
  std::vector<double> times = {};  // s
  std::vector<MotionSeries> series = {};
};

class MotionFrames {
 public:
  explicit MotionFrames(int frames, std::size_t most_points = kMostPointsShown)
      : frames_(frames), most_points_(most_points) {}

  // The first drawing sets the shown objects. An object that a later drawing lacks stays where it was, and
  // new objects are not shown. A point that is not finite stays, too.
  void add(const Drawing& drawing);

  // The ids of the first drawing's strands that are not shown; and the number of all its strands.
  const std::vector<int>& unseen() const { return unseen_; }
  std::size_t strands_in_all() const { return strands_in_all_; }

  // A point's error is at most 1 / 131070 of the box of all drawn points. Points that flew farther than ten
  // times the first frame's size are at the box's border.
  std::string json(const MotionStory& story) const;

  // The last frame alone, for a page that is open while it is computed: {"data", "planes"}, whose data are
  // base64 of 3 x points floats of 32 bits, m, the lowest byte first, and whose planes are as above. Call add
  // first.
  std::string last_json() const;
  void keep_last();  // frames before the last one are not kept

 private:
  void begin(const Drawing& drawing);
  void put(std::size_t point, const Vector3d& at);

  int frames_;
  std::size_t most_points_;
  std::size_t points_ = 0, first_rod_ = 0, strands_in_all_ = 0;
  std::map<std::uint32_t, std::size_t> first_point_;  // for each shown strand, by its id
  std::map<std::uint32_t, int> size_of_;
  std::vector<int> strands_, unseen_;
  std::vector<double> rod_radii_;
  std::vector<Colour> rod_colours_;
  StrandsDrawing look_;  // without strands
  std::vector<Sheet> sheets_;
  std::vector<PlacedMesh> meshes_;
  std::vector<std::vector<Plane>> planes_;  // for each frame
  std::vector<Eigen::Vector3f> all_;        // frame after frame
};

}  // namespace hair
