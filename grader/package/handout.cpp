// STAFF ONLY. Packs the handout, and lets its gates stop files that must not ship.
#include "grader/package/handout.h"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "grader/archive/archive_writer.h"
#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/intake/archives/archive.h"
#include "grader/package/course_texts.h"
#include "grader/package/manifest.h"
#include "grader/package/pages.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "hair/view/view_page.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;

const std::string top_folder = "hair-assignment/";
// Eight letters hash all other files but pages: hand-ins name the handout that they were made with.
const std::string kVersion = "version.txt";
constexpr std::size_t most_bytes = std::size_t{64} << 20;

std::string read_file(const fs::path& path, const std::string& where) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  if (!fs::is_regular_file(path) || !(bytes << in.rdbuf()))
    throw BadInput(where + ": " + path.string() + " can't be read; it must be a file that is not empty");
  return bytes.str();
}

Paths solved_files(const Course& course) {
  Paths solved;
  for (const Exercise& exercise : course.exercises)
    if (exercise.role == Role::given) solved.insert(stub_of(exercise));
  return solved;
}

std::string bytes_of(const ManifestLine& line, const HandoutSources& sources) {
  const std::string golden = "golden/";
  if (!line.source.starts_with(golden)) return read_file(sources.root / line.source, line.where);
  const fs::path made = sources.golden / line.source.substr(golden.size());
  if (!fs::exists(made))
    throw BadInput(line.where + ": " + made.string() +
                   " is not made yet; start this by ./grader/grade, which makes it, or build the targets "
                   "hair_golden and hair_motions");
  return read_file(made, line.where);
}

// Each scene that ships has the reference's run beside it, as the build made it.
void add_motions(std::vector<ManifestLine>& lines) {
  const std::string scenes = "hair/scenes/";
  std::vector<ManifestLine> added;
  for (const ManifestLine& line : lines)
    if (line.source.starts_with(scenes) && line.source.ends_with(".json")) {
      const std::string name = line.source.substr(scenes.size());
      added.push_back({"golden/motions/" + name, "given/hair/motions/" + name, line.where});
    }
  lines.insert(lines.end(), added.begin(), added.end());
}

// Lists the lines that ship. A scene ships if the course has all exercises that it calls.
std::vector<ManifestLine> lines_of(const HandoutSources& sources, const Course& course) {
  std::vector<ManifestLine> lines = read_manifest(sources.root, course);
  Paths absent;
  for (const ManifestLine& line : lines)
    if (line.source == "golden/scenes.md") absent = absent_scenes(bytes_of(line, sources), course);
  std::erase_if(lines, [&](const ManifestLine& line) { return absent.contains(line.source); });
  add_motions(lines);
  return lines;
}

// Lists the files that ship if all exercises are assigned.
Paths whole_handout(const HandoutSources& sources, Course course) {
  for (Exercise& exercise : course.exercises) exercise.role = Role::assigned;
  Paths paths;
  for (const ManifestLine& line : lines_of(sources, course)) paths.insert(line.destination);
  return with_pages(paths);
}

// Removes each exercise's files: text, categories, checks, stub and contract.
Paths without_exercises(Paths paths, const Course& course) {
  for (const Exercise& exercise : course.exercises)
    for (const std::string& own :
         {exercise.folder + "/text.md", exercise.folder + "/text.html", exercise.folder + "/categories.json",
          exercise.folder + "/check.cpp", stub_of(exercise), exercise.header})
      paths.erase(own);
  return paths;
}

// Puts the player around a list of two motions.
std::string view_of(const std::string& runs) {
  const auto list = nlohmann::json::parse(runs);
  return hair::view_page({{"right", list.at(0).dump()}, {"wrong", list.at(1).dump()}});
}

fs::path packed_list(const HandoutSources& sources) {
  return sources.root / "handout/packed.txt";
}

Paths accepted_files(const HandoutSources& sources) {
  std::istringstream list(read_file(packed_list(sources), "handout/packed.txt"));
  Paths accepted;
  for (std::string line; std::getline(list, line);)
    if (!line.empty() && line[0] != '#') accepted.insert(line);
  return accepted;
}

// Reads the solutions in each form: the reference, and right programs. Cases and tests may resemble public
// checks.
Files solutions_of(const HandoutSources& sources, const Course& course) {
  Files files;
  const auto add = [&](const fs::path& path) {
    files[path.string()] = read_file(sources.root / "reference" / path, path.string());
  };
  for (const Exercise& exercise : course.exercises) {
    add(fs::path(exercise.id) / exercise.file);
    std::error_code none;
    const fs::path right = fs::path(exercise.id) / "right";
    for (const auto& entry : fs::directory_iterator(sources.root / "reference" / right, none))
      add(right / entry.path().filename());
  }
  return files;
}

// Dates files by the newest commit. Sources without a commit, or with one in the future, get a fixed date.
std::time_t date_of(const fs::path& root) {
  const hair::TemporaryFolder folder("handout-date");
  const fs::path said = folder.path() / "said";
  hair::exit_code_of(hair::start_program(
      {.words = {"/usr/bin/env", "git", "-C", root.string(), "log", "-1", "--format=%ct", "--", "."},
       .output = said,
       .errors = "/dev/null"}));
  const std::time_t date = std::atol(hair::bytes_of(said).c_str());
  return date > kArchiveDate && date <= std::time(nullptr) ? date : kArchiveDate;
}

void write_archive(const fs::path& path, const Files& files, std::time_t date) {
  std::vector<ArchiveEntry> entries;
  for (const auto& [name, bytes] : files) entries.push_back({top_folder + name, bytes, "", 0});
  try {
    write_tar_gz(path, entries, date);
  } catch (const std::runtime_error& problem) {
    throw BadInput(problem.what());
  }
}

Files read_archive(const fs::path& path) {
  Archive archive(path, path.string(), {.unpacked_bytes = most_bytes, .entries = 10000, .with_hidden = true});
  const std::vector<Entry> entries = archive.list();
  std::vector<std::size_t> all;
  for (const Entry& entry : entries) {
    if (entry.kind != Entry::Kind::file || !entry.shown.starts_with(top_folder))
      throw HandoutError("the archive holds " + entry.shown + ", which is no file in " + top_folder);
    all.push_back(all.size());
  }
  Files files;
  archive.visit(all, [&](std::size_t index, const Container::Read& read) {
    const std::string name = entries[index].shown.substr(top_folder.size());
    if (!files.emplace(name, read(most_bytes)).second)
      throw HandoutError("the archive holds " + name + " twice");
  });
  return files;
}

void check_gates(const fs::path& archive, const HandoutSources& sources, const Course& course) {
  const Files handout = read_archive(archive);
  const Paths solved = solved_files(course);
  Paths listed{kVersion};
  for (const ManifestLine& line : lines_of(sources, course)) listed.insert(line.destination);
  check_listing(handout, handout.contains("README.html") ? with_pages(listed) : listed);
  check_canary(handout, solved);
  check_reference_lines(handout, solutions_of(sources, course), solved);
}

// Removes the file at its end, unless it was renamed.
struct TemporaryFile {
  fs::path path;
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
};

}  // namespace

void check_pages(const Files& pages, const HandoutSources& sources, const Course& course) {
  check_canary(pages, {});
  check_reference_lines(pages, solutions_of(sources, course), {});
}

Files handout_files(const HandoutSources& sources, const Course& course) {
  const Paths solved = solved_files(course);
  const std::vector<ManifestLine> lines = lines_of(sources, course);
  Shipped shipped;
  Paths missing = whole_handout(sources, course);
  for (const ManifestLine& line : lines) {
    shipped[project_path(line)] = line.destination;
    missing.erase(line.destination);
  }
  Files files;
  for (ManifestLine line : lines) {
    const fs::path source = line.source;
    const std::string id = source.parent_path().filename().string();
    if (solved.contains(line.destination)) line.source = "reference/" + id + "/" + source.filename().string();
    std::string bytes = bytes_of(line, sources);
    if (line.destination == "exercises.json") bytes = course_json(bytes, course);
    std::string categories;
    if (const Exercise* own = course.find(id); own != nullptr) {
      if (line.destination == own->folder + "/categories.json") bytes = course_categories(bytes, *own);
      if (line.destination == own->folder + "/text.md")
        categories = course_categories(
            read_file(sources.root / source.parent_path() / "categories.json", line.where), *own);
    }
    if (source.filename() == kRuns) bytes = view_of(bytes);
    if (line.destination.ends_with(".md"))
      bytes = course_text(bytes, line, course, shipped, missing, categories);
    files[line.destination] = bytes;
  }
  std::string all;
  for (const auto& [path, bytes] : files) all += path + "\n" + sha256(bytes) + "\n";
  files[kVersion] = sha256(all).substr(0, 8) + "\n";
  return files;
}

void accept_files(const HandoutSources& sources, const Course& course) {
  std::string list =
      "# The accepted files of the handout with all exercises, without those that exercises.json names.\n"
      "# \"hairgrade handout --accept\" writes this list. In grading, students' code is compiled with these "
      "headers and\n# the exercises'.\n";
  for (const std::string& path : without_exercises(whole_handout(sources, course), course))
    list += path + "\n";
  hair::write_file(packed_list(sources), list);
}

std::string make_handout(const HandoutSources& sources, const Course& course, const fs::path& out) {
  if (fs::is_directory(out))
    throw BadInput(out.string() + ": is a folder; name the archive to write, like handout.tar.gz");
  if (const fs::path folder = fs::absolute(out).parent_path(); !fs::is_directory(folder))
    throw BadInput(out.string() + ": there is no folder " + folder.string() +
                   "; make it first, or write elsewhere");
  check_accepted(without_exercises(whole_handout(sources, course), course), accepted_files(sources));
  const TemporaryFile part{out.string() + ".part"};
  Files files = handout_files(sources, course);
  const std::string remark = add_pages(files, sources.root / "grader/package/pages.js");
  write_archive(part.path, files, date_of(sources.root));
  check_gates(part.path, sources, course);
  fs::rename(part.path, out);
  return remark;
}

}  // namespace grader::package
