// STAFF ONLY. Packs the project for Gradescope.
#include "grader/package/gradescope_package.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "grader/archive/archive_writer.h"
#include "grader/course/input.h"
#include "grader/text/shell_word.h"
#include "hair/io/files/read_file.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;

// The platform's limit leaves no results: grading ends before. Half a processor writes the last of them in a
// few seconds.
constexpr int kSecondsBefore = 30;

// The build needs only these.
constexpr const char* kParts[] = {"CMakeLists.txt", "CMakePresets.json", "solver",  "particles",
                                  "hair",           "reference",         "handout", "grader"};

std::string bytes_of_source(const fs::path& path) {
  const std::string bytes = hair::bytes_of(path);
  if (bytes.empty() && fs::file_size(path) > 0) throw BadInput(path.string() + ": can't be read");
  return bytes;
}

bool is_program(const fs::path& path) {
  return (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

// Skips hidden files, such as an editor's, and links.
std::vector<fs::path> files_of(const fs::path& project) {
  std::vector<fs::path> files;
  for (const char* part : kParts) {
    if (!fs::exists(project / part))
      throw BadInput((project / part).string() + ": is not there; package from the whole project");
    if (fs::is_regular_file(project / part)) files.push_back(project / part);
    if (!fs::is_directory(project / part)) continue;
    for (fs::recursive_directory_iterator entry(project / part), end; entry != end; ++entry) {
      if (entry->path().filename().string().starts_with("."))
        entry.disable_recursion_pending();
      else if (entry->is_regular_file() && !entry->is_symlink())
        files.push_back(entry->path());
    }
  }
  std::ranges::sort(files);
  return files;
}

std::string filled_in(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

bool is_below(const std::string& path, std::initializer_list<const char*> folders) {
  return std::ranges::any_of(folders, [&](const char* folder) { return path.starts_with(folder); });
}

// The public checks' package leaves these out: hidden cases, the engine, right and wrong solutions, and their
// tests.
bool is_hidden(const std::string& path) {
  const fs::path file(path);
  const bool tests = path.starts_with("grader/") && file.stem().string().ends_with("_test");
  const std::string name = file.filename().string();
  const bool calls =
      name == "calls.h" || name == "proxies.h" || name == "CMakeLists.txt" || name.starts_with("make_");
  return tests || file.extension() == ".samples" || (path.starts_with("reference/") && !calls) ||
         is_below(path, {"grader/samples/solutions/", "grader/tests/", "reference/engine/"});
}

// Returns the project's files by their paths in it.
Files whole_project(const fs::path& project) {
  Files files;
  for (const fs::path& file : files_of(project))
    files[file.lexically_relative(project).string()] = bytes_of_source(file);
  return files;
}

// Replaces each file of the reference that students don't have by a stub.
Files without_reference(Files all, const HandoutSources& sources, const Course& course) {
  Files files = all;
  Paths solved;
  Files reference;
  std::erase_if(files, [](const auto& file) { return is_hidden(file.first); });
  for (const Exercise& exercise : course.exercises) {
    const std::string path = "reference/" + exercise.id + "/" + exercise.file;
    const std::string solution = all[path];
    if (exercise.role == Role::given)
      solved.insert(path);
    else
      reference[exercise.file] = solution;
    files[path] =
        exercise.role == Role::given ? solution : files["handout/" + exercise.folder + "/" + exercise.file];
  }
  for (const auto& [path, bytes] : handout_files(sources, course))
    if (path.starts_with("check/golden/")) files["handout/" + path] = bytes;
  check_reference_lines(files, reference, solved);
  return files;
}

}  // namespace

void write_gradescope_package(const HandoutSources& sources, const std::string& secret, const Course& course,
                              const GradescopePackage& package) {
  const fs::path& project = sources.root;
  std::string options;
  if (!package.checks_only) options += " --secret \"$source/secret\"";
  if (package.course) options += " --course \"$source/course.json\"";
  if (!package.hand_in.empty() && !package.checks_only)
    options += " --hand-in " + shell_word(package.hand_in);
  std::vector<ArchiveEntry> entries;
  for (const char* script : {"setup.sh", "run_autograder"}) {
    std::string text = bytes_of_source(project / "grader/package/gradescope" / script);
    text = filled_in(text, "$PROGRAM\"", package.checks_only ? "hairchecks\"" : "hairgrade\" gradescope");
    text = filled_in(text, " \"$OPTIONS\"", options);
    text = filled_in(text, "\"$PARTS\"", package.checks_only ? "hairchecks_parts" : "hairgrade_parts");
    text = filled_in(text, "\"$SECONDS_IN_ALL\"", std::to_string(60 * package.minutes - kSecondsBefore));
    entries.push_back({.path = script, .bytes = text, .link = "", .mode = 0755});
  }
  if (!package.checks_only) entries.push_back({.path = "secret", .bytes = secret, .link = "", .mode = 0600});
  if (package.course)
    entries.push_back(
        {.path = "course.json", .bytes = bytes_of_source(*package.course), .link = "", .mode = 0600});
  Files files = whole_project(project);
  if (package.checks_only) files = without_reference(std::move(files), sources, course);
  for (const auto& [path, bytes] : files)
    entries.push_back({.path = "hair/" + path,
                       .bytes = bytes,
                       .link = "",
                       .mode = is_program(project / path) ? 0755U : 0644U});
  const fs::path part = package.out.string() + ".part";
  try {
    write_file(part, "");
    fs::permissions(part, fs::perms(0600));  // before it holds the secret
    write_zip(part, entries);
    fs::rename(part, package.out);
  } catch (const std::runtime_error& problem) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw BadInput(problem.what());
  }
}

std::string advice_for_gradescope(const Course& course, int minutes) {
  // These are a right hand-in's CPU seconds for an exercise, and for the work before and after all of them:
  // grader/MEASURED.md, "On Gradescope".
  constexpr double kForAnExercise = 7, kBesides = 20, kProcessor = 0.5, kSlower = 1.5;
  // A hand-in that uses up each limit takes this many times the time of a right one, whatever its budget.
  constexpr double kGreedy = 4;
  const auto asked = std::ranges::count_if(
      course.exercises, [&](const Exercise& exercise) { return course.asks_for(exercise); });
  const double cpu_seconds = kForAnExercise * static_cast<double>(asked) + kBesides;
  const Budget& budget = course.budget;
  const double worst =
      std::min(kGreedy * cpu_seconds, cpu_seconds + budget.worker_cpu_seconds + budget.compiler_cpu_seconds +
                                          budget.suite_cpu_seconds) /
          kProcessor +
      budget.idle_seconds;
  const auto in_minutes = [](double seconds) {
    return std::to_string(static_cast<int>(std::ceil(seconds / 60)));
  };
  std::string advice = "On Gradescope: the base image Ubuntu 22.04. ";
  if (cpu_seconds / kProcessor * kSlower <= 60 * minutes - kSecondsBefore)
    advice += "The default container (0.5 CPU, 0.75 GB) and a timeout of " + std::to_string(minutes) +
              " minutes suffice";
  else
    advice += "Choose 1 CPU, 1.5 GB and a timeout of " +
              in_minutes(cpu_seconds / kProcessor * kSlower + kSecondsBefore) +
              " minutes or more, and package with --minutes";
  return advice + ": a right hand-in of " + std::to_string(asked) + " exercises takes about " +
         in_minutes(cpu_seconds / kProcessor) +
         " minutes there. One that uses up its whole budget can take " + in_minutes(worst) +
         "; what the time ends keeps the exercises that were done.";
}

}  // namespace grader::package
