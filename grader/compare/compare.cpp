// STAFF ONLY. Computes the distances of two pictures.
#include "grader/compare/compare.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"

namespace grader::inline compare {
namespace {

// Blurring is linear: the difference of blurred pictures is the blurred difference.
double blurred_rmse(const hair::Image& a, const hair::Image& b) {
  const Kernel kernel = gaussian(kBlur, static_cast<int>(3 * kBlur));
  double squares = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    Plane difference(a.width, a.height);
    for (std::size_t i = 0; i < difference.values.size(); ++i)
      difference.values[i] =
          static_cast<float>(int{a.pixels[3 * i + channel]} - int{b.pixels[3 * i + channel]}) / 255;
    for (const float value : filtered(difference, kernel, kernel).values) squares += double{value} * value;
  }
  return a.pixels.empty() ? 0 : std::sqrt(squares / static_cast<double>(a.pixels.size()));
}

constexpr std::size_t kLongestName = 60;

std::string names(const std::vector<std::string>& all) {
  std::string line;
  for (const std::string& name : all) line += (line.empty() ? "" : ", ") + hair::printable(name);
  return line;
}

}  // namespace

PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test) {
  return compare_pictures(reference, test, flip(reference, test));
}

PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test, const ErrorMap& map) {
  PictureDistance distance;
  distance.identical = reference == test;
  distance.blurred_rmse = blurred_rmse(reference, test);
  double sum = 0;
  for (const float value : map.values) {
    sum += value;
    distance.flip_max = std::max(distance.flip_max, double{value});
  }
  distance.flip_mean = map.values.empty() ? 0 : sum / static_cast<double>(map.values.size());
  return distance;
}

bool is_worse(const ComparedPair& a, const ComparedPair& b) {
  const auto key = [](const ComparedPair& pair) {
    return std::tuple(pair.obstacle.empty(), -pair.distance.flip_mean, -pair.distance.flip_max,
                      std::string_view(pair.name));
  };
  return key(a) < key(b);
}

bool is_complete(const Comparison& comparison) {
  return comparison.only_in_reference.empty() && comparison.only_in_test.empty() &&
         count_compared(comparison) == comparison.pairs.size();
}

std::size_t count_identical(const Comparison& comparison) {
  return static_cast<std::size_t>(
      std::count_if(comparison.pairs.begin(), comparison.pairs.end(),
                    [](const ComparedPair& pair) { return pair.distance.identical; }));
}

std::size_t count_compared(const Comparison& comparison) {
  return static_cast<std::size_t>(
      std::count_if(comparison.pairs.begin(), comparison.pairs.end(),
                    [](const ComparedPair& pair) { return pair.obstacle.empty(); }));
}

std::string comparison_table(const Comparison& comparison) {
  std::string text;
  for (const auto& [folder, alone] : {std::pair(comparison.reference, comparison.only_in_reference),
                                      std::pair(comparison.test, comparison.only_in_test)})
    if (!alone.empty()) text += "only in " + hair::printable(folder, 4096) + ": " + names(alone) + "\n";
  const std::size_t same = count_identical(comparison), compared = count_compared(comparison);
  std::size_t longest = 7;
  for (const ComparedPair& pair : comparison.pairs)
    if (pair.obstacle.empty() && !pair.distance.identical)
      longest = std::max(longest, hair::printable(pair.name, kLongestName).size());
  const auto line = [&](const std::string& name, const char* numbers) {
    text += name + std::string(longest - name.size(), ' ') + numbers + "\n";
  };
  for (const ComparedPair& pair : comparison.pairs)
    if (!pair.obstacle.empty())
      text += "not compared: " + hair::printable(pair.name, kLongestName) + ": " + pair.obstacle + "\n";
  if (same < compared) line("picture", "  blurred RMSE    FLIP  FLIP max");
  for (const ComparedPair& pair : comparison.pairs) {
    if (!pair.obstacle.empty() || pair.distance.identical) continue;
    std::array<char, 100> numbers;
    std::snprintf(numbers.data(), numbers.size(), "  %12.4f  %6.4f  %8.4f", pair.distance.blurred_rmse,
                  pair.distance.flip_mean, pair.distance.flip_max);
    line(hair::printable(pair.name, kLongestName), numbers.data());
  }
  if (same > 0)
    text += std::to_string(same) + " of " + std::to_string(compared) + " the same, pixel for pixel\n";
  return text;
}

std::string comparison_json(const Comparison& comparison) {
  using Json = nlohmann::ordered_json;
  Json pairs = Json::array();
  for (const ComparedPair& pair : comparison.pairs)
    pairs.push_back(pair.obstacle.empty() ? Json{{"name", pair.name},
                                                 {"width", pair.width},
                                                 {"height", pair.height},
                                                 {"identical", pair.distance.identical},
                                                 {"blurred_rmse", pair.distance.blurred_rmse},
                                                 {"flip_mean", pair.distance.flip_mean},
                                                 {"flip_max", pair.distance.flip_max}}
                                          : Json{{"name", pair.name}, {"not_compared", pair.obstacle}});
  const Json all = {{"pairs", pairs},
                    {"only_in_first", comparison.only_in_reference},
                    {"only_in_second", comparison.only_in_test}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

namespace fs = std::filesystem;
using hair::BadInput;
using Names = std::set<std::string>;

std::string shown(const fs::path& path) {
  return hair::printable(path.string(), 4096);
}

enum class Kind { file, folder };

Kind kind_of(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return Kind::folder;
  if (fs::is_regular_file(status)) return Kind::file;
  const std::string why = fs::exists(status) ? "is neither a file nor a folder"
                          : error            ? error.message()
                                             : "is not there";
  throw BadInput(shown(path) + ": " + why + "; give two PNG pictures, or two folders of them");
}

// Returns "a.png", also for "a.PNG"; empty for a name of another kind.
std::string with_small_ending(const std::string& name) {
  constexpr std::string_view ending = ".png";
  if (name.size() <= ending.size()) return "";
  const std::size_t stem = name.size() - ending.size();
  for (std::size_t i = 0; i < ending.size(); ++i)
    if (std::tolower(static_cast<unsigned char>(name[stem + i])) != ending[i]) return "";
  return name.substr(0, stem) + std::string(ending);
}

Names pictures_in(const fs::path& folder) {
  Names names;
  std::error_code error;
  for (fs::directory_iterator item(folder, error), end; !error && item != end; item.increment(error)) {
    const std::string name = item->path().filename().string();
    if (!with_small_ending(name).empty()) names.insert(name);
  }
  if (error)
    throw BadInput(shown(folder) + ": can't be read (" + error.message() + "); give a folder of pictures");
  if (names.empty()) throw BadInput(shown(folder) + ": holds no file *.png; give a folder of pictures");
  return names;
}

}  // namespace

PicturePairs find_pairs(const fs::path& reference, const fs::path& test) {
  const Kind kind = kind_of(reference);
  if (kind_of(test) != kind) {
    const bool first = kind == Kind::folder;
    throw BadInput(shown(reference) + " is a " + (first ? "folder" : "file") + ", " + shown(test) + " is a " +
                   (first ? "file" : "folder") + "; give two PNG pictures, or two folders of them");
  }
  PicturePairs found;
  if (kind == Kind::file) {
    found.pairs.push_back({test.filename().string(), reference, test});
    return found;
  }
  const Names first = pictures_in(reference), all_others = pictures_in(test);
  Names second = all_others;  // have no partner yet
  const auto pair = [&](const std::string& name, const std::string& other) {
    found.pairs.push_back({other, reference / name, test / other});
  };
  Names rest;
  for (const std::string& name : first) second.erase(name) > 0 ? pair(name, name) : void(rest.insert(name));
  std::map<std::string, std::string> others;
  for (const std::string& name : second) others.emplace(with_small_ending(name), name);
  for (const std::string& name : rest) {
    const auto other = others.extract(with_small_ending(name));
    other ? pair(name, other.mapped()) : found.only_in_reference.push_back(name);
    if (other) second.erase(other.mapped());
  }
  found.only_in_test.assign(second.begin(), second.end());
  std::sort(found.pairs.begin(), found.pairs.end(),
            [](const PicturePair& a, const PicturePair& b) { return a.name < b.name; });
  if (found.pairs.empty())
    throw BadInput(shown(reference) + " and " + shown(test) +
                   ": no picture of one has a name of the other's, " + "as " +
                   hair::printable(*first.begin()) + " and " + hair::printable(*all_others.begin()) +
                   "; pictures are matched by their names");
  return found;
}

}  // namespace grader::compare
