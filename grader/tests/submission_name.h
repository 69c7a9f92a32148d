// STAFF ONLY. Returns a sample's name as reports have it.
#pragma once

#include <cctype>
#include <string>

namespace grader {

// Cleans a name as intake does.
inline std::string submission_name(std::string name) {
  for (char& letter : name)
    if (!isalnum(static_cast<unsigned char>(letter)) && std::string("._-").find(letter) == std::string::npos)
      letter = '_';
  if (!name.empty() && !isalnum(static_cast<unsigned char>(name.front()))) name.insert(0, "x");
  return name == "staff" ? "staff_" : name;
}

}  // namespace grader
