// STAFF ONLY. Reads the list of files that ship.
#include "grader/package/manifest.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

#include "grader/course/input.h"
#include "grader/package/gates.h"
#include "hair/io/files/read_file.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string read_path(const std::string& text, const std::string& where) {
  const fs::path path = text;
  if (text.empty() || path.is_absolute() || path.lexically_normal() != path || *path.begin() == "..")
    throw BadInput(where + ": \"" + text + "\" is no path; write one like handout/README.md, without \"..\"");
  return text;
}

std::string default_destination(const std::string& source) {
  const std::string handout = "handout/";
  return source.starts_with(handout) ? source.substr(handout.size()) : "given/" + source;
}

// Collects lines, and no destination twice.
class Lines {
 public:
  void add(const ManifestLine& line, bool absent) {
    const auto [other, is_new] = taken_.emplace(line.destination, line.where);
    if (!is_new)
      throw BadInput(line.where + ": " + line.destination + " is already the destination of " +
                     other->second + "; each file needs its own");
    if (!absent) lines_.push_back(line);
  }

  // `folder` is a line whose source and destination end with /. Its subfolders are skipped.
  void add_files_of(const fs::path& root, const ManifestLine& folder, bool absent) {
    Files files;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / folder.source, error))
      if (const std::string name = entry.path().filename().string();
          !entry.is_directory() && !is_test_by_name(name))
        files[folder.source + name] = hair::bytes_of(entry.path());
    if (files.empty()) throw BadInput(folder.where + ": " + folder.source + " is no folder with files in it");
    check_folder(files, folder.where);
    for (const auto& [source, bytes] : files)
      add({source, folder.destination + source.substr(folder.source.size()), folder.where}, absent);
  }

  std::vector<ManifestLine> take() { return std::move(lines_); }

 private:
  std::vector<ManifestLine> lines_;
  std::map<std::string, std::string> taken_;  // destination -> where
};

// All files of its folder ship. Its contract ships in every course, since other code includes it.
void add_exercise(Lines& lines, const fs::path& root, const Exercise& exercise) {
  const std::string where = "exercises.json: " + exercise.id, folder = "handout/" + exercise.folder;
  const bool absent = exercise.role == Role::absent;
  std::error_code error;
  Paths names{exercise.file};
  for (const fs::directory_entry& entry : fs::directory_iterator(root / folder, error))
    names.insert(entry.path().filename().string());
  for (const std::string& name : names) {
    const std::string ships = name == kRuns ? "view.html" : name;
    lines.add({folder + "/" + name, name == exercise.file ? stub_of(exercise) : exercise.folder + "/" + ships,
               where},
              absent);
  }
  if (!exercise.header.empty()) lines.add({exercise.header, exercise.header, where}, false);
}

}  // namespace

std::string stub_of(const Exercise& exercise) {
  return "stubs/" + exercise.file + ".stub";
}

std::vector<ManifestLine> read_manifest(const fs::path& root, const Course& course) {
  const fs::path file = root / "handout/manifest.txt";
  std::ifstream in(file);
  if (!in) throw BadInput(file.string() + ": can't be read; it must list the files of the handout");
  Lines lines;
  for (const Exercise& exercise : course.exercises) add_exercise(lines, root, exercise);
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    const std::string where = file.string() + ":" + std::to_string(number);
    text = trimmed(text);
    if (text.empty() || text[0] == '#') continue;

    bool absent = false;
    if (const auto colon = text.find(':'); colon != std::string::npos) {
      std::istringstream ids(text.substr(0, colon));
      for (std::string id; std::getline(ids, id, ',');) {
        const Exercise* exercise = course.find(trimmed(id));
        if (!exercise)
          throw BadInput(where + ": there is no exercise \"" + trimmed(id) +
                         "\"; write one of exercises.json");
        absent = absent || exercise->role == Role::absent;
      }
      text = trimmed(text.substr(colon + 1));
    }
    const auto arrow = text.find("->");
    ManifestLine line;
    line.where = where;
    line.source = read_path(trimmed(text.substr(0, arrow)), where);
    line.destination = arrow == std::string::npos ? default_destination(line.source)
                                                  : read_path(trimmed(text.substr(arrow + 2)), where);
    if (line.source.ends_with('/') != line.destination.ends_with('/'))
      throw BadInput(where + ": a folder's source and destination both end with /, a file's do not");
    if (line.source.ends_with('/'))
      lines.add_files_of(root, line, absent);
    else
      lines.add(line, absent);
  }
  return lines.take();
}

}  // namespace grader::package
