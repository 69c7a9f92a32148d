// STAFF ONLY.
#include "grader/package/gates.h"

#include <cctype>
#include <sstream>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace grader {
namespace {

const std::string canary = "STAFF ONLY";
constexpr std::size_t least_lines = 4, least_with_letters = 3, least_letters = 30;

// Lines that give nothing away.
bool is_common(const std::string& line) {
  for (const char* begin : {"#include", "using ", "namespace "})
    if (line.starts_with(begin)) return true;
  return false;
}

// The letters, digits and underscores of a text, one after the other: neither its layout nor marks of comments change them.
struct Letters {
  std::string text;
  std::vector<int> line;            // of each
  std::vector<std::size_t> begins;  // of each line that is neither blank nor common, and the end
};

Letters letters_of(const std::string& text) {
  Letters letters;
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || is_common(line.substr(first))) continue;
    letters.begins.push_back(letters.text.size());
    for (const char letter : line)
      if (letter == '_' || std::isalnum(static_cast<unsigned char>(letter))) {
        letters.text += letter;
        letters.line.push_back(number);
      }
  }
  letters.begins.push_back(letters.text.size());
  return letters;
}

// As few consecutive lines as there may be, by their letters.
struct Run {
  std::string_view letters;
  int line;  // the first
};

std::vector<Run> runs_of(const Letters& letters) {
  std::vector<Run> runs;
  const std::vector<std::size_t>& begins = letters.begins;
  for (std::size_t first = 0; first + least_lines < begins.size(); ++first) {
    if (begins[first] == begins[first + 1]) continue;
    std::size_t end = first, with_letters = 0;
    const auto is_enough = [&] {
      return end - first >= least_lines && with_letters >= least_with_letters &&
             begins[end] - begins[first] >= least_letters;
    };
    for (; !is_enough() && end + 1 < begins.size(); ++end) with_letters += begins[end] < begins[end + 1];
    if (is_enough())
      runs.push_back({std::string_view(letters.text).substr(begins[first], begins[end] - begins[first]),
                      letters.line[begins[first]]});
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

void check_reference_lines(const Files& handout, const Files& reference, const Paths& solved) {
  struct Secret {
    std::string run, place;  // "conj_grad.cpp:17"
  };
  std::unordered_map<std::string, std::vector<Secret>> secrets;  // by the first letters of a run
  for (const auto& [name, text] : reference) {
    const Letters letters = letters_of(text);
    for (const Run& run : runs_of(letters))
      secrets[std::string(run.letters.substr(0, least_letters))].push_back(
          {std::string(run.letters), name + ":" + std::to_string(run.line)});
  }
  for (const auto& [path, text] : handout) {
    if (solved.contains(path)) continue;
    const Letters letters = letters_of(text);
    for (std::size_t i = 0; i + least_letters <= letters.text.size(); ++i) {
      const auto found = secrets.find(letters.text.substr(i, least_letters));
      if (found == secrets.end()) continue;
      for (const Secret& secret : found->second)
        if (letters.text.compare(i, secret.run.size(), secret.run) == 0)
          throw HandoutError(path + ":" + std::to_string(letters.line[i]) +
                             ": what it says stands in reference/" + secret.place +
                             ", too; write it in another way");
    }
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
