// STAFF ONLY. Prints the table of samples.
#include "grader/samples/sample.h"

#include <algorithm>
#include <sstream>

namespace grader::inline samples {
namespace {

// Returns "S1 partly 18, S2 missing".
std::string losses(const Sample& sample) {
  std::ostringstream text;
  for (const std::string& id : sample.listed) {
    const ExpectedResult& expected = sample.expected.at(id);
    text << (text.str().empty() ? "" : ", ") << id << " " << expected.status;
    if (expected.points) text << " " << *expected.points;
  }
  return text.str().empty() ? "passed" : text.str();
}

// Returns "S1 0": the most points that it may get.
std::string most_points(const Attack& attack) {
  std::ostringstream text;
  if (attack.most_points) text << *attack.most_points;
  for (const auto& [id, points] : attack.most_points_of)
    text << (text.str().empty() ? "" : ", ") << id << " " << points;
  return text.str();
}

void write_row(std::ostream& out, const Sample& sample) {
  out << "| `" << sample.name << "` | " << sample.shows << " | ";
  if (sample.attack) out << sample.attack->fence << " | ";
  out << losses(sample) << " |";
  if (sample.attack)
    out << " " << most_points(*sample.attack) << " | " << sample.attack->most_cpu_seconds << " |";
  out << "\n";
}

}  // namespace

std::string table_of(const std::vector<Sample>& samples) {
  std::ostringstream out;
  std::string group;
  for (const Sample& sample : samples) {
    if (sample.attack) continue;
    if (sample.group != group)
      out << (group.empty() ? "" : "\n") << "## " << sample.title
          << "\n\n| sample | what it shows | gets |\n|---|---|---|\n";
    group = sample.group;
    write_row(out, sample);
  }
  for (const std::string place : kPlaces) {
    out << "\n## Attacks: " << place
        << "\n\n| sample | what it tries | stopped by | gets | points | CPU s |\n|---|---|---|---|---|--:|\n";
    for (const Sample& sample : samples)
      if (sample.attack && sample.attack->place == place) write_row(out, sample);
  }
  return out.str();
}

}  // namespace grader::samples
