// STAFF ONLY. The picture of grader/ARCHITECTURE.md: the rooms, and the data's way through them.
#pragma once

#include <string>
#include <vector>

namespace grader {

struct Room {
  std::string folder;              // from the project's root
  std::vector<std::string> lines;  // what it does
  int column, row;
  bool caged = false;  // meets strangers' bytes or code in a sandbox
};

// Data goes from the one to the other. Rooms side by side, or one above the other.
struct Arrow {
  std::string from, to;  // folders
  std::string what;
  bool and_back = false;
};

const std::vector<Room>& rooms();
const std::vector<Arrow>& arrows();

// The picture, as SVG.
std::string architecture();

}  // namespace grader
