// STAFF ONLY. Reads a group of samples, GROUP.samples.
#include "grader/samples/group_file.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>

#include "grader/course/input.h"
#include "hair/io/files/read_file.h"

namespace grader::inline samples {

void GroupFile::fail(const GroupLine& line, const std::string& problem) const {
  throw BadInput(path.string() + ":" + std::to_string(line.number) + ": " + problem);
}

std::string GroupFile::take_word(const GroupLine& line, std::string& rest) const {
  std::size_t end = rest.find(' ');
  std::string word = rest.substr(0, end);
  if (rest.starts_with('"')) {
    for (end = 1; end < rest.size() && rest[end] != '"'; ++end)
      if (rest[end] == '\\') ++end;
    end = std::min(end + 1, rest.size());
    const nlohmann::json text = nlohmann::json::parse(rest.substr(0, end), nullptr, false);
    if (!text.is_string()) fail(line, rest.substr(0, end) + " is no JSON string");
    word = text.get<std::string>();
  }
  rest = end >= rest.size() ? "" : rest.substr(end + 1);
  return word;
}

double GroupFile::number(const GroupLine& line, const std::string& text, double least, double most) const {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= least && value <= most)
    return value;
  std::ostringstream problem;
  problem << "\"" << text << "\" is not right; give a number from " << least << " to " << most;
  fail(line, problem.str());
}

GroupFile read_group_file(const std::filesystem::path& path) {
  GroupFile group{path, {}, {}};
  std::istringstream text(hair::read_file(path, 16 << 20, "a group of samples"));
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    GroupLine read{number, line.substr(0, 1), line.substr(1)};
    if (std::string("-=+*").find(line[0]) == std::string::npos) {
      const std::size_t end = line.find(' ');
      read.key = line.substr(0, end);
      read.rest = end == std::string::npos ? "" : line.substr(end + 1);
    }
    if (read.key == "sample") group.samples.emplace_back();
    (group.samples.empty() ? group.common : group.samples.back()).push_back(std::move(read));
  }
  return group;
}

}  // namespace grader::samples
