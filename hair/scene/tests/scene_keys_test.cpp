// STAFF ONLY. hair/scenes/README.md names the keys that the reader knows, and no others, with the bounds that it has.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "reading.h"

namespace reference_tests {
namespace {

using nlohmann::json;
using Bounds = std::map<std::string, std::string>;  // of each key, as the README writes them

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(' ');
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(' ') + 1 - from);
}

std::vector<std::string> split(const std::string& text, const std::string& by) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at = text.find(by); at != std::string::npos;
       from = at + by.size(), at = text.find(by, from))
    parts.push_back(text.substr(from, at - from));
  parts.push_back(text.substr(from));
  return parts;
}

// The tables under each heading: "hair[].roots" -> its keys.
std::map<std::string, Bounds> documented() {
  std::map<std::string, Bounds> sections;
  std::ifstream in(HAIR_SCENES "/README.md");
  std::string line, section;
  while (std::getline(in, line)) {
    if (line.rfind("## ", 0) == 0) {
      section = line.substr(3);
      section.erase(std::remove(section.begin(), section.end(), '`'), section.end());
    } else if (line.rfind("| `", 0) == 0 && !section.empty()) {
      const std::vector<std::string> cells = split(line, "|");
      EXPECT_EQ(cells.size(), 7U) << line;
      for (const std::string& key : split(trimmed(cells[1]), ", "))
        sections[section][key.substr(1, key.size() - 2)] = trimmed(cells[4]);
    }
  }
  return sections;
}

std::string after(const std::string& text, const std::string& mark) {
  const std::size_t at = text.rfind(mark);
  return at == std::string::npos ? "" : text.substr(at + mark.size());
}

// What the reader says of a value that is surely wrong, as the README writes bounds.
std::string bounds_in(const std::string& said) {
  if (said.find("not a list of three numbers") != std::string::npos) return "three";
  if (const std::string range = after(said, "give a number from "); !range.empty()) return range;
  if (const std::string range = after(said, "give a whole number from "); !range.empty())
    return "whole, " + std::regex_replace(range, std::regex(" to "), " to ");
  if (const std::string words = after(said, "write one of: "); !words.empty()) return words;
  if (said.find("write true or false") != std::string::npos) return "true, false";
  return "";
}

// Asks the reader, by mistakes in each object of a scene: which keys it knows there, and their bounds.
class Asked {
 public:
  explicit Asked(const std::string& scene) : scene_(json::parse(scene)) {
    ask(scene_, "", json::json_pointer());
  }
  const std::map<std::string, Bounds>& sections() const { return sections_; }

 private:
  std::string said_with(const json::json_pointer& place, const json& value) const {
    json wrong = scene_;
    wrong[place] = value;
    return complaint(wrong.dump());
  }

  void ask(const json& value, const std::string& path, const json::json_pointer& place) {
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) ask(value[i], path + "[]", place / i);
      return;
    }
    if (!value.is_object()) return;
    std::string section = path.empty() ? "The scene" : path;
    if (value.contains("groom")) section += " with a groom";
    if (value.contains("style")) section += " that grows";
    if (value.contains("cloth")) section += " with a cloth";
    Bounds& known = sections_[section];
    for (const std::string& key : split(after(said_with(place / "?", 0), ": "), ", ")) known.emplace(key, "");
    for (const auto& [key, item] : value.items()) {
      std::string bounds = bounds_in(said_with(place / key, item.is_boolean() ? json("?") : json::object()));
      // A vector's bounds are those of its numbers.
      if (bounds == "three") bounds = bounds_in(said_with(place / key / 0, "?"));
      if (!bounds.empty()) known[key] = bounds;
      ask(item, path.empty() ? key : path + "." + key, place / key);
    }
  }

  json scene_;
  std::map<std::string, Bounds> sections_;
};

// Both small scenes together have every object there is.
std::map<std::string, Bounds> read() {
  std::map<std::string, Bounds> sections = Asked(small_scene()).sections();
  const Asked step(small_scene(R"("steps_per_frame": 8)", R"("step": 0.0041666666666666666)"));
  sections["The scene"]["step"] = step.sections().at("The scene").at("step");
  const Asked linked(linked_scene());
  sections["The scene"].merge(std::map(linked.sections().at("The scene")));
  for (const char* section : {"links", "links.strips"}) sections[section] = linked.sections().at(section);
  const Asked groom(
      R"({"shows": "a groom", "frames": 1, "hair": [{"groom": {"file": "a", "scale": 1, "every": 1,
    "strands": 1, "points": 2, "move": [0, 0, 0]}, "model": "mass_spring", "clamped": true, "root_velocity": [0, 0, 0]}]})");
  for (const char* section : {"hair[] with a groom", "hair[].groom"})
    sections[section] = groom.sections().at(section);
  const Asked grown(
      R"({"shows": "hair that grows", "frames": 1, "hair": [{"groom": {"style": "wavy", "strands": 1,
    "points": 60, "length": 0.2, "head": "bust", "at": [0, 0, 0], "seed": 1}}]})");
  sections["hair[].groom that grows"] = grown.sections().at("hair[].groom that grows");
  const Asked bust(R"({"shows": "a bust", "frames": 1, "hair": [{"segments": 1, "length": 0.1,
    "roots": {"bust": {"count": 1, "at": [0, 0, 0], "lift": 0.3, "seed": 1}}}],
    "obstacles": [{"bust": {"at": [0, 0, 0]}}]})");
  for (const char* section : {"hair[].roots.bust", "obstacles[].bust"})
    sections[section] = bust.sections().at(section);
  const Asked still(R"({"shows": "still hair", "frames": 1, "render": {},
    "hair": [{"segments": 1, "length": 0.1, "roots": {"list": [{"position": [0, 0, 0]}]}}],
    "still_hair": [{"groom": {"style": "ponytail", "strands": 1}}]})");
  sections["still_hair[]"] = still.sections().at("still_hair[] with a groom");
  return sections;
}

TEST(SceneKeys, AreThoseOfTheReadme) {
  const auto written = documented(), known = read();
  std::set<std::string> sections;
  for (const auto& [section, keys] : written) sections.insert(section);
  for (const auto& [section, keys] : known) {
    EXPECT_EQ(sections.erase(section), 1U) << "README.md lacks \"" << section << "\"";
    if (written.count(section) == 0) continue;
    for (const auto& [key, bounds] : keys)
      EXPECT_TRUE(written.at(section).count(key)) << section << ": " << key;
    for (const auto& [key, bounds] : written.at(section))
      EXPECT_TRUE(keys.count(key)) << section << ": " << key;
  }
  for (const std::string& section : sections)
    ADD_FAILURE() << "no object of a scene is \"" << section << "\"";
}

TEST(SceneKeys, HaveTheBoundsOfTheReadme) {
  const auto written = documented();
  int compared = 0;
  for (const auto& [section, keys] : read())
    for (const auto& [key, bounds] : keys) {
      if (bounds.empty() || written.count(section) == 0 || written.at(section).count(key) == 0) continue;
      const std::string& here = written.at(section).at(key);
      if (here == "a particle") continue;
      EXPECT_EQ(here, bounds) << section << ": " << key;
      ++compared;
    }
  EXPECT_GT(compared, 80);
}

}  // namespace
}  // namespace reference_tests
