// STAFF ONLY. Applies a sample's edit to a solution.
#include "grader/samples/edit.h"

#include <algorithm>
#include <sstream>

#include "grader/course/input.h"

namespace grader::inline samples {
namespace {

// "a\nb\n" has three lines, the last of them empty: nothing is lost.
std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0;;) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    if (end == std::string::npos) return lines;
    at = end + 1;
  }
}

[[noreturn]] void refuse(const Edit& edit, const std::string& problem) {
  throw BadInput(edit.where + ": " + edit.file + " " + problem);
}

// Finds the edit's lines, which must be in exactly one place.
std::size_t find_once(const std::vector<std::string>& lines, const Edit& edit) {
  std::vector<std::string> wanted;
  for (const EditLine& line : edit.lines)
    if (line.mark != '+') wanted.push_back(line.text);
  if (wanted.empty()) refuse(edit, "is not told where; begin with one of its lines, marked by - or =");
  std::vector<std::size_t> found;
  for (std::size_t at = 0; at + wanted.size() <= lines.size(); ++at)
    if (std::equal(wanted.begin(), wanted.end(), lines.begin() + static_cast<std::ptrdiff_t>(at)))
      found.push_back(at);
  if (found.size() == 1) return found[0];
  for (const std::string& line : wanted)
    if (std::ranges::find(lines, line) == lines.end())
      refuse(edit, "has no line \"" + line + "\"; copy the line exactly");
  if (found.empty()) refuse(edit, "has these lines, but not one after the other; make an edit of each");
  std::ostringstream places;
  for (const std::size_t at : found) places << (at == found[0] ? "" : ", ") << at + 1;
  refuse(edit, "has \"" + wanted[0] + "\" " + std::to_string(found.size()) + " times, in lines " +
                   places.str() + "; add a line before or after, marked by =");
}

}  // namespace

std::string edited(const std::string& text, const std::string& file, const std::vector<Edit>& edits) {
  const std::vector<std::string> lines = split_lines(text);
  std::vector<bool> goes(lines.size(), false);
  std::vector<std::string> comes(lines.size() + 1);  // come before each line
  for (const Edit& edit : edits) {
    if (edit.file != file) continue;
    std::size_t at = find_once(lines, edit);
    for (const EditLine& line : edit.lines) {
      if (line.mark == '+') {
        comes[at] += line.text + "\n";
        continue;
      }
      if (line.mark == '-') {
        if (goes[at]) refuse(edit, "loses \"" + line.text + "\" by two edits; make one of them");
        goes[at] = true;
      }
      ++at;
    }
  }
  std::string result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    result += comes[i];
    if (!goes[i]) result += lines[i] + (i + 1 < lines.size() ? "\n" : "");
  }
  return result + comes[lines.size()];
}

}  // namespace grader::samples
