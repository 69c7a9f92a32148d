// states.csv: the same numbers as states.bin, a line for each particle of each frame. For particles of toys
// the field `strand` is empty. Each number has the fewest digits, at most 17, that read back the same value.
#pragma once

#include <filesystem>
#include <vector>

#include "hair/lab/run/output_file.h"
#include "particles/state.h"

namespace hair {

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
