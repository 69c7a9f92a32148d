// states.bin: the states of a run, frame by frame. Little-endian throughout:
//
//   8 bytes     "HAIRRUN1"
//   u32 s       strands
//   u32 n       particles, those of strands first, then those of toys
//   u32 f       frames
//   u32 c       what the coordinates are (hair/strand/body.h): 0, positions
//   u32 x s     particles of each strand; their sum is at most n
//   zeros       up to a multiple of 8 bytes from the start
//   f times     f64 time (s), f64 x 3n coordinates (m), f64 x 3n of their rates (m/s)
#pragma once

#include <filesystem>
#include <vector>

#include "hair/lab/run/output_file.h"
#include "hair/strand/body.h"
#include "particles/state.h"

namespace hair {

struct StateFrame {
  double time;  // s
  particles::State state;
};

struct StatesFile {
  std::vector<int> strands;  // particles of each
  int particles = 0;         // of all, with those of toys
  Coordinates coordinates = Coordinates::positions;
  std::vector<StateFrame> frames;
};

class StatesWriter {
 public:
  // All throw BadInput if it can't be written.
  StatesWriter(const std::filesystem::path& file, const std::filesystem::path& shown,
               const std::vector<int>& strands, int particles,
               Coordinates coordinates = Coordinates::positions);
  void add(double time, const particles::State& state);  // 3n each
  void close();

 private:
  OutputFile file_;
  std::uint32_t frames_ = 0;
};

// Throws BadInput: not such a file, of coordinates that it does not know, cut off, or longer than it says.
StatesFile read_states(const std::filesystem::path& file);

}  // namespace hair
