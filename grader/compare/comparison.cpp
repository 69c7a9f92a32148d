// STAFF ONLY. Sorts compared pictures, and writes their table and JSON.
#include "grader/compare/comparison.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <tuple>

#include "hair/io/files/printable.h"

namespace grader::inline compare {
namespace {

constexpr std::size_t kLongestName = 60;

std::string names(const std::vector<std::string>& all) {
  std::string line;
  for (const std::string& name : all) line += (line.empty() ? "" : ", ") + hair::printable(name);
  return line;
}

}  // namespace

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

}  // namespace grader::compare
