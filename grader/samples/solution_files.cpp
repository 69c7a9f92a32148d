// STAFF ONLY. Copies a sample's solution files and edits them.
#include "grader/samples/solution_files.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "grader/course/input.h"
#include "grader/samples/sample.h"
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

// "a\nb\n" has three lines, the last of them empty: nothing is lost.
std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0;;) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    if (end == std::string::npos) return lines;
    at = end + 1;
  }
}

[[noreturn]] void refuse(const Edit& edit, const std::string& problem) {
  throw BadInput(edit.where + ": " + edit.file + " " + problem);
}

// Finds the edit's lines, which must be in exactly one place.
std::size_t find_once(const std::vector<std::string>& lines, const Edit& edit) {
  std::vector<std::string> wanted;
  for (const EditLine& line : edit.lines)
    if (line.mark != '+') wanted.push_back(line.text);
  if (wanted.empty()) refuse(edit, "is not told where; begin with one of its lines, marked by - or =");
  std::vector<std::size_t> found;
  for (std::size_t at = 0; at + wanted.size() <= lines.size(); ++at)
    if (std::equal(wanted.begin(), wanted.end(), lines.begin() + static_cast<std::ptrdiff_t>(at)))
      found.push_back(at);
  if (found.size() == 1) return found[0];
  for (const std::string& line : wanted)
    if (std::ranges::find(lines, line) == lines.end())
      refuse(edit, "has no line \"" + line + "\"; copy the line exactly");
  if (found.empty()) refuse(edit, "has these lines, but not one after the other; make an edit of each");
  std::ostringstream places;
  for (const std::size_t at : found) places << (at == found[0] ? "" : ", ") << at + 1;
  refuse(edit, "has \"" + wanted[0] + "\" " + std::to_string(found.size()) + " times, in lines " +
                   places.str() + "; add a line before or after, marked by =");
}

// Returns the text with all edits that name the file. Each searches its lines in the original text. Throws
// BadInput if they are missing, or occur several times.
std::string edited(const std::string& text, const std::string& file, const std::vector<Edit>& edits) {
  const std::vector<std::string> lines = split_lines(text);
  std::vector<bool> goes(lines.size(), false);
  std::vector<std::string> comes(lines.size() + 1);  // come before each line
  for (const Edit& edit : edits) {
    if (edit.file != file) continue;
    std::size_t at = find_once(lines, edit);
    for (const EditLine& line : edit.lines) {
      if (line.mark == '+') {
        comes[at] += line.text + "\n";
        continue;
      }
      if (line.mark == '-') {
        if (goes[at]) refuse(edit, "loses \"" + line.text + "\" by two edits; make one of them");
        goes[at] = true;
      }
      ++at;
    }
  }
  std::string result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    result += comes[i];
    if (!goes[i]) result += lines[i] + (i + 1 < lines.size() ? "\n" : "");
  }
  return result + comes[lines.size()];
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
