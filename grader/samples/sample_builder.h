// STAFF ONLY. Makes a sample line by line. sample.h explains the lines.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grader/course/course.h"
#include "grader/samples/group_file.h"
#include "grader/samples/sample.h"

namespace grader::inline samples {

// A category by which an exercise is graded, as the exercise's categories.json declares it.
struct SampleCategory {
  std::string name, title;  // "Energy", and for students "The energy"
  double points = 0;
};

using SampleCategories = std::map<std::string, std::vector<SampleCategory>>;  // by exercise

// Reads the categories of all exercises of PROJECT/handout. Throws BadInput with the file and the JSON path.
SampleCategories read_categories(const std::filesystem::path& project, const Course& course);

// Returns the points of an exercise if the categories with these titles fail.
double points_without(const std::vector<SampleCategory>& categories, const std::vector<std::string>& failed);

// This is one sample, line by line.
struct SampleBuilder {
  const GroupFile& group;
  const Course& course;
  const SampleCategories& categories;
  std::map<std::string, std::vector<EditLine>> parts = {};
  Sample sample = {};
  std::string others = {};
  std::map<std::string, const GroupLine*> named = {};  // are the exercises that have a line
  std::map<std::string, ExpectedResult> given = {};
  std::vector<EditLine>* open = nullptr;  // takes the lines of an edit or a part

  [[noreturn]] void fail(const GroupLine& line, const std::string& problem) const {
    group.fail(line, problem);
  }

  std::string path(const GroupLine& line, std::string rest) const {
    if (rest.empty()) fail(line, line.key + " lacks the path in the archive");
    return rest.starts_with('"') ? take(line, rest) : rest;
  }

  std::string take(const GroupLine& line, std::string& rest) const { return group.take_word(line, rest); }

  double number(const GroupLine& line, const std::string& text, double least, double most) const {
    return group.number(line, text, least, most);
  }

  const Exercise& exercise(const GroupLine& line, const std::string& id) const {
    const Exercise* found = course.find(id);
    if (found == nullptr) fail(line, "there is no exercise " + id);
    return *found;
  }

  Attack& attack() {
    if (!sample.attack) sample.attack.emplace();
    return *sample.attack;
  }

  ExpectedResult& expect(const GroupLine& line, const std::string& id) {
    named[id] = &line;
    return given[id];
  }

  void add(const std::string& path_in_archive, SampleFile::Kind kind, const std::string& value,
           std::uint64_t zeros = 0) {
    sample.files.push_back({path_in_archive, kind, value, zeros});
  }

  void add_to_edit(const GroupLine& line) {
    if (open == nullptr) fail(line, "this line belongs to no edit; write \"edit\" in a line before it");
    if (line.key != "*") return open->push_back({line.key[0], line.rest});
    const auto part = parts.find(line.rest);
    if (part == parts.end()) fail(line, "the group has no part \"" + line.rest + "\"");
    open->insert(open->end(), part->second.begin(), part->second.end());
  }

  void read(const GroupLine& line);
  void complete(const GroupLine& first);
};

struct SampleKey {
  std::string_view name;
  std::string_view kind;  // a sample's own lines replace the group's of the same kind
  bool repeated = false;
  void (*read)(SampleBuilder&, const GroupLine&) = nullptr;
};

// Returns null for an unknown word.
const SampleKey* key_of(const GroupLine& line);

struct SampleFormName {
  SampleForm form;
  std::string_view name, ending;
};
inline constexpr SampleFormName kSampleForms[] = {{SampleForm::zip, "zip", ".zip"},
                                                  {SampleForm::tar_gz, "tar.gz", ".tar.gz"},
                                                  {SampleForm::folder, "folder", ""}};

}  // namespace grader::samples
