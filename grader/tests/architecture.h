// STAFF ONLY. The picture of grader/ARCHITECTURE.md: the folders, and the data's way through them.
#pragma once

#include <string>
#include <vector>

namespace grader {

struct Room {
  std::string folder;              // starts at the project's root
  std::vector<std::string> lines;  // describe its work
  int column, row;
  bool sandboxed = false;  // runs strangers' bytes or code in a sandbox
};

// Data goes from one to the other. Both stand side by side, or one above the other.
struct Arrow {
  std::string from, to;  // are folders
  std::string what;
  bool and_back = false;
};

const std::vector<Room>& rooms();
const std::vector<Arrow>& arrows();

// Returns the picture, as SVG.
std::string architecture();

}  // namespace grader
