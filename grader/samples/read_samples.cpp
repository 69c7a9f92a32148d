// STAFF ONLY. Reads samples and their groups, and prints their table.
#include "grader/samples/sample.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "grader/course/course.h"
#include "grader/samples/group_file.h"
#include "grader/samples/sample_builder.h"

namespace grader::inline samples {
namespace {

// Joins the group's lines of kinds that the sample lacks, and its own.
std::vector<GroupLine> all_lines(const GroupFile& group, const std::vector<GroupLine>& own) {
  std::map<std::string_view, const GroupLine*> first_of;  // by key
  std::set<std::string_view> kinds;
  for (const GroupLine& line : own)
    if (const SampleKey* key = key_of(line)) {
      kinds.insert(key->kind);
      if (!first_of.emplace(key->name, &line).second && !key->repeated)
        group.fail(line, "\"" + line.key + "\" is there already, in line " +
                             std::to_string(first_of[key->name]->number));
    }
  std::vector<GroupLine> lines;
  bool taken = true;  // an edit's lines follow their edit
  for (const GroupLine& line : group.common) {
    if (const SampleKey* key = key_of(line)) taken = !kinds.contains(key->kind);
    if (taken) lines.push_back(line);
  }
  lines.insert(lines.end(), own.begin(), own.end());
  for (const char* needed : {"title", "shows", "form"})
    if (std::ranges::find(lines, needed, &GroupLine::key) == lines.end())
      group.fail(own.front(), "sample \"" + own.front().rest + "\" lacks a line \"" + needed + "\"");
  return lines;
}

// All right programs with one name, reference/<ID>/right/NAME.cpp, are the sample right-NAME.
void add_right_programs(const std::filesystem::path& project, const Course& course, GroupFile& group) {
  std::map<std::string, std::vector<GroupLine>> files;  // by that name
  for (const Exercise& exercise : course.exercises)
    if (const auto folder = project / "reference" / exercise.id / "right"; std::filesystem::exists(folder))
      for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().stem().string();
        files[name].push_back({0, "file", name + " " + exercise.file});
      }
  for (const auto& [name, lines] : files) {
    std::vector<GroupLine>& sample = group.samples.emplace_back();
    sample = {
        {0, "sample", "right-" + name}, {0, "shows", "All right programs " + name + "."}, {0, "form", "zip"}};
    sample.insert(sample.end(), lines.begin(), lines.end());
  }
}

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

std::string Sample::file_name() const {
  for (const SampleFormName& candidate : kSampleForms) {
    if (candidate.form == form) return name + std::string(candidate.ending);
  }
  return name;
}

std::vector<Sample> read_samples(const std::filesystem::path& project) {
  const Course course = read_course(project / "handout" / "exercises.json");
  const SampleCategories known = read_categories(project, course);
  std::map<std::string, std::filesystem::path> groups;  // by name
  for (const Exercise& exercise : course.exercises)
    if (const auto own = project / "reference" / exercise.id / "wrong.samples"; std::filesystem::exists(own))
      groups[exercise.id] = own;
  for (const auto& entry : std::filesystem::directory_iterator(project / "grader/samples/groups"))
    if (entry.path().extension() == ".samples") groups[entry.path().stem().string()] = entry.path();
  std::vector<Sample> samples;
  std::set<std::string> names;
  for (const auto& [name, file] : groups) {
    GroupFile group = read_group_file(file);
    if (name == "right") add_right_programs(project, course, group);
    for (const std::vector<GroupLine>& own : group.samples) {
      const GroupLine& first = own.front();
      if (!names.insert(first.rest).second)
        group.fail(first, "the name \"" + first.rest + "\" is taken; give each sample its own");
      const std::vector<GroupLine> lines = all_lines(group, own);
      SampleBuilder builder{group, course, known};
      builder.sample.group = name;
      for (const GroupLine& line : lines) builder.read(line);
      builder.complete(first);
      samples.push_back(std::move(builder.sample));
    }
  }
  return samples;
}

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
