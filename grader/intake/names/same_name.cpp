// STAFF ONLY. Ranks files with the same name.
#include "grader/intake/names/same_name.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <tuple>

#include "grader/intake/names/exercise_names.h"

namespace grader::inline intake {
namespace {

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& all, std::string_view word) {
  return std::ranges::find(all, word) != all.end();
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

// Takes a name in lower case.
bool is_aside(std::string_view name) {
  constexpr std::array<std::string_view, 6> kNames{"out", "bin", "obj", "debug", "release", "x64"};
  constexpr std::array<std::string_view, 9> kWords{"build", "backup", "backups", "bak",  "old",
                                                   "older", "copy",   "kopie",   "trash"};
  if (is_one_of(kNames, name)) return true;
  while (!name.empty()) {
    const auto end = static_cast<std::size_t>(std::ranges::find_if_not(name, is_letter) - name.begin());
    if (is_one_of(kWords, name.substr(0, end))) return true;
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  return false;
}

// Visits the folders on the way to a file, without the file.
template <class Take>
void each_folder(std::string_view path, Take take) {
  for (std::size_t end = path.find('/'); end != path.npos; end = path.find('/')) {
    take(path.substr(0, end));
    path.remove_prefix(end + 1);
  }
}

bool any_folder(std::string_view path, const auto& holds) {
  bool any = false;
  each_folder(path, [&](std::string_view name) { any = any || holds(name); });
  return any;
}

// Splits a path into its text and its version numbers.
struct Place {
  std::string without_numbers;
  std::vector<int> numbers = {};
};

Place place_of(const Candidate& candidate) {
  constexpr std::array<std::string_view, 8> kWords{"version",  "ver",     "v",   "rev",
                                                   "revision", "attempt", "try", "draft"};
  Place place;
  each_folder(in_lower_case(candidate.path), [&](std::string_view name) {
    const Numbered numbered = without_number(name);
    std::string_view word = numbered.name;
    while (!word.empty() && !is_letter(word.back())) word.remove_suffix(1);
    word.remove_prefix(word.find_last_of(" _-.") + 1);
    const bool is_version = numbered.number >= 0 && (numbered.bracket || is_one_of(kWords, word));
    place.without_numbers += (is_version ? std::string(numbered.name) + "#" : std::string(name)) + "/";
    if (is_version) place.numbers.push_back(numbered.number);
  });
  if (candidate.number >= 0) place.without_numbers += "#";
  place.numbers.push_back(candidate.number);
  return place;
}

}  // namespace

bool is_build(std::string_view folder) {
  return folder.starts_with("cmake-build") ||
         (folder.starts_with("build") && (folder.size() == 5 || !is_letter(folder[5])));
}

bool lies_in_a_build(std::string_view path) {
  return any_folder(path, is_build);
}

bool is_set_aside(std::string_view path) {
  return any_folder(in_lower_case(path), is_aside);
}

std::size_t put_best_first(std::vector<Candidate>& candidates) {
  constexpr std::ptrdiff_t kMostCompared = 64;  // bounds the search for versions
  const auto rank = [](const Candidate& one) {
    const bool given = any_folder(in_lower_case(one.path), [](auto name) { return name == "student"; });
    return std::tuple(is_set_aside(one.path), one.renamed, !given);
  };
  auto least = rank(candidates.front());
  for (const Candidate& one : candidates) least = std::min(least, rank(one));
  const auto begin = candidates.begin();
  auto end = std::stable_partition(begin, candidates.end(),
                                   [&](const Candidate& one) { return rank(one) == least; });
  if (end - begin > kMostCompared) return static_cast<std::size_t>(end - begin);

  std::map<std::string, std::vector<int>> newest;  // by place
  std::for_each(begin, end, [&](const Candidate& one) {
    const Place place = place_of(one);
    std::vector<int>& highest = newest[place.without_numbers];
    highest = std::max(highest, place.numbers);
  });
  end = std::stable_partition(begin, end, [&](const Candidate& one) {
    const Place place = place_of(one);
    return place.numbers == newest.at(place.without_numbers);
  });
  return static_cast<std::size_t>(end - begin);
}

}  // namespace grader::intake
