// states.bin: the states of a run, frame by frame. Little-endian throughout:
//
//   8 bytes     "HAIRRUN1"
//   u32 s       strands
//   u32 n       threes of coordinates: first those of strands, then those of toys. A particle has three
//   u32 f       frames
//   u32 c       the kind of coordinates of strands (hair/strand/body.h): 0 positions, 1 turns, 2 curvatures;
//               3: each strand has those of its model
//   u32 x s     threes of each strand; their sum is at most n
//   zeros       up to a multiple of 8 bytes from the start
//   f times     f64 time (s), f64 x 3n coordinates, f64 x 3n of their rates (1/s)
//
// Only if a control mesh links the strands, the broken links follow:
//
//   8 bytes     "BROKEN 1"
//   u32 l, b    links, and how many of them broke; b <= l
//   u32 x 2l    the particles of each link, counted through all strands
//   b times     u64 step (from 1), u64 link (from 0): broken at the step's end; in this order, each once
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "hair/lab/run/output_folder.h"
#include "hair/linked_guides/control_mesh.h"
#include "hair/strand/body.h"
#include "particles/state.h"

namespace hair {

struct LinksFile {
  std::vector<std::array<int, 2>> particles;  // for each link
  std::vector<BrokenLink> broken;
};

class StatesWriter {
 public:
  // All functions throw BadInput if the file can't be written. `strands` has the threes of coordinates of
  // each strand, `particles` those of strands and toys together; `coordinates` is ModelRow's.
  StatesWriter(const std::filesystem::path& file, const std::filesystem::path& shown,
               const std::vector<int>& strands, int particles, std::uint32_t coordinates = kPositions);
  void add(double time, const particles::State& state);  // 3n each
  void add(const LinksFile& links);                      // once, after the last frame
  void close();

 private:
  OutputFile file_;
  std::uint32_t frames_ = 0;
};

// states.csv: the same numbers, a line for each particle of each frame. The field `strand` is empty for toys.
// Each number has the fewest digits, at most 17, that read back the same value.
inline constexpr std::string_view kCsvHead = "frame,time,strand,particle,x,y,z,vx,vy,vz\n";

class CsvWriter {
 public:
  // All functions throw BadInput if the file can't be written.
  CsvWriter(const std::filesystem::path& file, const std::filesystem::path& shown, std::vector<int> strands);
  void add(double time, const particles::State& state);
  void close() { file_.close(); }

 private:
  OutputFile file_;
  std::vector<int> strands_;
  int frame_ = 0;
};

}  // namespace hair
