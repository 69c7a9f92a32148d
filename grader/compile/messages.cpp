// STAFF ONLY. Picks a student's lines out of the output of compiler and linker.
#include "grader/compile/messages.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <vector>

#include "grader/course/input.h"

namespace grader::inline compile {
namespace {

// Returns the first `most` lines, and how many more there are.
std::string first_lines(const std::vector<std::string>& lines, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) text += lines[i] + "\n";
  if (lines.size() > most) text += "... and " + std::to_string(lines.size() - most) + " more\n";
  return text;
}

// True for "a.h:11:7: error: ...": it concerns a line of code, not a tool.
bool is_error(const std::string& line) {
  for (const std::string saying : {": error: ", ": fatal error: "})
    if (const std::size_t at = line.find(saying); at != std::string::npos && at > 0)
      return std::isdigit(static_cast<unsigned char>(line[at - 1])) != 0;
  return false;
}

}  // namespace

std::string own_messages(const std::string& log, const std::string& file) {
  const std::string handout = "/handout/";
  std::istringstream lines(log);
  std::string own;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(file + ":") || is_error(line))
      own += line.substr(line.starts_with(handout) ? handout.size() : 0) + "\n";
  return own;
}

std::string own_warnings(const std::string& log, const std::string& file) {
  std::istringstream text(log);
  std::vector<std::string> lines;
  std::set<std::string> seen;
  for (std::string line; std::getline(text, line);)
    if (line.starts_with(file + ":") && line.find(": warning: ") != std::string::npos &&
        seen.insert(line).second)
      lines.push_back(line);
  std::stable_partition(lines.begin(), lines.end(), [](const std::string& line) {
    return line.ends_with("uninitialized]");  // -Wuninitialized, -Wmaybe-uninitialized
  });
  return first_lines(lines, 20);
}

std::string undefined_names(const std::string& log) {
  const std::string saying = "undefined reference to ";
  std::istringstream text(log);
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (std::string line; std::getline(text, line);) {
    const std::size_t at = line.find(saying), first = at + saying.size() + 1;
    if (at == std::string::npos || line.size() < first + 2) continue;
    // The name stands between the linker's quotes.
    const std::string name = "  " + printable(line.substr(first, line.size() - 1 - first));
    if (seen.insert(name).second) names.push_back(name);
  }
  return first_lines(names, 10);
}

}  // namespace grader::compile
