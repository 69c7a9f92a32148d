// STAFF ONLY. Reads the owners in Gradescope's export.
#include "grader/intake/layouts/gradescope.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "grader/course/input.h"
#include "grader/intake/names/names.h"

namespace grader::inline intake {
namespace {

// Finds a key with Ruby's colon or without; "" if there is none.
std::string text_at(const YAML::Node& map, const std::string& key) {
  for (const std::string& name : {":" + key, key})
    if (map.IsMap() && map[name] && map[name].IsScalar() && map[name].Tag() != "tag:yaml.org,2002:null")
      return map[name].Scalar();
  return {};
}

YAML::Node list_at(const YAML::Node& map, const std::string& key) {
  for (const std::string& name : {":" + key, key})
    if (map.IsMap() && map[name] && map[name].IsSequence()) return map[name];
  return YAML::Node(YAML::NodeType::Sequence);
}

Owner gradescope_owner(const YAML::Node& row, const std::string& folder) {
  std::vector<Owner> people;
  for (const YAML::Node& person : list_at(row, "submitters"))
    people.push_back(
        {.name = text_at(person, "name"), .id = text_at(person, "sid"), .email = text_at(person, "email")});
  if (people.size() == 1) return people.front();
  Owner owner{.id = folder.substr(folder.find('_') + 1)};
  if (people.empty()) return owner;
  owner.group = true;
  std::ranges::sort(people, {}, [](const Owner& one) { return one.id + "\n" + one.email + "\n" + one.name; });
  owner.members = people;
  owner.id.clear();  // a later hand-in has another number, so the members identify the group
  for (const Owner& member : people) {
    owner.id += (owner.id.empty() ? "" : "_") + (member.id.empty() ? member.email : member.id);
    owner.name += (owner.name.empty() ? "" : ", ") + member.name;
  }
  return owner;
}

}  // namespace

std::map<std::string, GradescopeRow> read_gradescope_metadata(const std::string& yaml,
                                                              const std::string& file) {
  // The parser takes half a kilobyte for each value. A class has some thousand values for each hand-in.
  constexpr std::ptrdiff_t kMostValues = 10'000'000;
  constexpr std::string_view kBeforeValues = ",:[{-?\n";
  if (std::ranges::count_if(yaml, [&](char c) { return kBeforeValues.find(c) != kBeforeValues.npos; }) >
      kMostValues)
    throw BadInput(file + ": holds more than a class's data; export it from Gradescope again");
  try {
    const YAML::Node all = YAML::Load(yaml);
    if (!all.IsMap())
      throw BadInput(file + ": is no table of submissions; export them from Gradescope again");
    std::map<std::string, GradescopeRow> rows;
    for (const auto& row : all) {  // the pair has bases of its own: no structured binding
      if (!row.first.IsScalar()) continue;
      const std::string folder = row.first.Scalar();
      rows[folder] = {gradescope_owner(row.second, folder), text_at(row.second, "created_at")};
    }
    return rows;
  } catch (const YAML::Exception& error) {
    throw BadInput(file + ", line " + std::to_string(error.mark.line + 1) + ": is no YAML (" +
                   printable(error.msg) + "); export it from Gradescope again");
  }
}

}  // namespace grader::intake
