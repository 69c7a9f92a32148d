// STAFF ONLY. Copies a sample's solution files and edits them.
#include "grader/samples/solution_files.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "grader/course/input.h"
#include "hair/io/files/read_file.h"

namespace grader::inline samples {
namespace {

namespace fs = std::filesystem;

// A solution is "reference", "stub" or a right one; one of no exercise is in grader/samples/solutions/.
fs::path file_of(const std::string& solution, const Exercise& exercise, const fs::path& project) {
  if (solution == "reference") return project / "reference" / exercise.id / exercise.file;
  if (solution == "stub") return project / "handout" / exercise.folder / exercise.file;
  const fs::path right = project / "reference" / exercise.id / "right" / (solution + ".cpp");
  return fs::exists(right) ? right : project / "grader/samples/solutions" / solution / exercise.file;
}

std::string as_on_windows(const std::string& text) {
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : text) {
    if (c == '\n') windows += '\r';
    windows += c;
  }
  return windows;
}

}  // namespace

std::map<std::string, std::string> solution_files(const Sample& sample, const fs::path& project) {
  std::map<std::string, std::string> texts;
  std::set<std::string> names;
  const Course course = read_course(project / "handout/exercises.json");
  for (const SampleFile& file : sample.files) {
    if (file.kind != SampleFile::Kind::solution) continue;
    const std::string name = fs::path(file.path).filename().string();
    const auto exercise = std::ranges::find(course.exercises, name, &Exercise::file);
    const fs::path source =
        exercise == course.exercises.end() ? fs::path() : file_of(file.value, *exercise, project);
    if (!fs::is_regular_file(source)) {
      throw BadInput("sample \"" + sample.name + "\": " + file.path + ": " + source.string() +
                     " is not there; name \"reference\", \"stub\" or a file of reference/ID/right/");
    }
    const std::string text = edited(hair::bytes_of(source), name, sample.edits);
    texts[file.path] = sample.windows ? as_on_windows(text) : text;
    names.insert(name);
  }
  for (const Edit& edit : sample.edits)
    if (!names.contains(edit.file))
      throw BadInput(edit.where + ": it has no " + edit.file + " of a solution");
  return texts;
}

bool runs_and_loses_points(const std::string& status) {
  static const std::set<std::string> all = {"partly", "wrong", "crashed", "timed out", "out of memory"};
  return all.contains(status);
}

std::vector<SampleProgram> programs_of(const Exercise& exercise, const fs::path& project,
                                       const std::function<bool(const Sample&, const std::string&)>& wanted) {
  std::vector<Sample> samples = read_samples(project);
  std::stable_partition(samples.begin(), samples.end(),
                        [](const Sample& sample) { return sample.group == "right"; });
  std::vector<SampleProgram> programs;
  for (const Sample& sample : samples) {
    const std::string& status = sample.expected.at(exercise.id).status;
    if (sample.attack || sample.group.starts_with("attacks-") || !wanted(sample, status)) continue;
    for (const auto& [path, source] : solution_files(sample, project))
      if (fs::path(path).filename() == exercise.file &&
          std::ranges::find(programs, source, &SampleProgram::source) == programs.end())
        programs.push_back({sample.name, source, status == "passed"});
  }
  return programs;
}

}  // namespace grader::samples
