// STAFF ONLY.
#include "grader/package/gates.h"

#include <sstream>
#include <vector>

namespace grader {
namespace {

const std::string canary = "STAFF ONLY";
constexpr std::size_t run_length = 4;

// Consecutive lines that say something, trimmed, and the number of the first. What a file includes gives
// nothing away.
struct Run {
  std::string text;
  int line;
};

std::vector<Run> runs_of(const std::string& text) {
  std::vector<std::pair<std::string, int>> lines;
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line.compare(first, 8, "#include") == 0) continue;
    lines.emplace_back(line.substr(first, line.find_last_not_of(" \t\r") - first + 1), number);
  }
  std::vector<Run> runs;
  for (std::size_t i = 0; i + run_length <= lines.size(); ++i) {
    Run run{"", lines[i].second};
    for (std::size_t k = i; k < i + run_length; ++k) run.text += lines[k].first + '\n';
    runs.push_back(run);
  }
  return runs;
}

}  // namespace

void check_listing(const Files& handout, const Paths& listed) {
  for (const auto& [path, bytes] : handout)
    if (!listed.contains(path))
      throw HandoutError("the archive holds " + path + ", which the manifest does not list");
  for (const std::string& path : listed)
    if (!handout.contains(path))
      throw HandoutError("the archive lacks " + path + ", which the manifest lists");
}

void check_canary(const Files& handout, const Paths& solved) {
  for (const auto& [path, bytes] : handout)
    if (!solved.contains(path) && bytes.find(canary) != std::string::npos)
      throw HandoutError(path + " says " + canary + ": it, or a part of it, is not for students");
}

void check_reference_lines(const Files& handout, const Files& reference, const Files& stubs,
                           const Paths& solved) {
  std::map<std::string, std::string> secret;  // a run -> "conj_grad.cpp:17"
  for (const auto& [name, text] : reference) {
    Paths in_stub;
    if (const auto stub = stubs.find(name); stub != stubs.end())
      for (const Run& run : runs_of(stub->second)) in_stub.insert(run.text);
    for (const Run& run : runs_of(text))
      if (!in_stub.contains(run.text)) secret.emplace(run.text, name + ":" + std::to_string(run.line));
  }
  for (const auto& [path, text] : handout) {
    if (solved.contains(path)) continue;
    for (const Run& run : runs_of(text))
      if (const auto found = secret.find(run.text); found != secret.end())
        throw HandoutError(path + ":" + std::to_string(run.line) + ": four lines stand in reference/" +
                           found->second + ", too; write them in another way");
  }
}

bool carries_canary(const std::string& text) {
  // A script's first line is its interpreter's, a page's may be its document type.
  std::istringstream in(text);
  std::string line;
  for (int number = 1; number <= 3 && std::getline(in, line); ++number)
    if (line.find(canary) != std::string::npos) return true;
  return false;
}

}  // namespace grader
