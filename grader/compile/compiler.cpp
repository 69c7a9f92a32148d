// STAFF ONLY. Makes an object of a student's file: from the cache, or by compiler and linker in sandboxes.
#include "grader/compile/compiler.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "grader/compile/cache.h"
#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/text/encoding.h"
#include "hair/io/files/read_file.h"

namespace grader::inline compile {
namespace fs = std::filesystem;
namespace {

// Returns the first `most` lines, and how many more there are.
std::string first_lines(const std::vector<std::string>& lines, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) text += lines[i] + "\n";
  if (lines.size() > most) text += "... and " + std::to_string(lines.size() - most) + " more\n";
  return text;
}

// True for "a.h:11:7: error: ...": it concerns a line of code, not a tool.
bool is_error(const std::string& line) {
  for (const std::string saying : {": error: ", ": fatal error: "})
    if (const std::size_t at = line.find(saying); at != std::string::npos && at > 0)
      return std::isdigit(static_cast<unsigned char>(line[at - 1])) != 0;
  return false;
}

// Returns the compiler's messages about `file`'s own lines, a line each, and its errors elsewhere: these come
// from definitions that this file repeats or functions that it calls wrongly.
std::string own_messages(const std::string& log, const std::string& file) {
  const std::string handout = "/handout/";
  std::istringstream lines(log);
  std::string own;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(file + ":") || is_error(line))
      own += line.substr(line.starts_with(handout) ? handout.size() : 0) + "\n";
  return own;
}

// Returns the warnings about `file`'s own lines, a line each: unset variables come first. Twenty at most.
std::string own_warnings(const std::string& log, const std::string& file) {
  std::istringstream text(log);
  std::vector<std::string> lines;
  std::set<std::string> seen;
  for (std::string line; std::getline(text, line);)
    if (line.starts_with(file + ":") && line.find(": warning: ") != std::string::npos &&
        seen.insert(line).second)
      lines.push_back(line);
  std::stable_partition(lines.begin(), lines.end(), [](const std::string& line) {
    return line.ends_with("uninitialized]");  // -Wuninitialized, -Wmaybe-uninitialized
  });
  return first_lines(lines, 20);
}

// Returns names that the linker does not find, a line each, as C++ writes them. Ten at most.
std::string undefined_names(const std::string& log) {
  const std::string saying = "undefined reference to ";
  std::istringstream text(log);
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (std::string line; std::getline(text, line);) {
    const std::size_t at = line.find(saying), first = at + saying.size() + 1;
    if (at == std::string::npos || line.size() < first + 2) continue;
    // The name stands between the linker's quotes.
    const std::string name = "  " + printable(line.substr(first, line.size() - 1 - first));
    if (seen.insert(name).second) names.push_back(name);
  }
  return first_lines(names, 10);
}

// The precompiled header.
constexpr double kHeaderSeconds = 300;  // is CPU time
constexpr std::size_t kHeaderBytes = std::size_t{512} << 20;
const std::vector<std::string> kHeaderLibraries = {"eigen"};

constexpr const char* kHeaderText = "#include \"particles/usual.h\"\n";

}  // namespace

Compiler::Compiler(const StagedKit& kit, fs::path cache, Isolation isolation)
    : toolchain_(kit, isolation), precompiled_(toolchain_, cache), cache_(std::move(cache)) {
  std::error_code error;
  if (fs::create_directories(cache_, error)) fs::permissions(cache_, fs::perms::owner_all);
  if (error) throw BadInput(cache_.string() + ": can't keep compiled objects there: " + error.message());
}

Compiled Compiler::compile(const Exercise& exercise, const std::string& source, const fs::path& job,
                           double cpu_seconds) const {
  const fs::path object = job / (exercise.id + ".so");
  const std::string hash = key(exercise, source);
  const fs::path kept = cache_ / (hash + ".object");
  std::unique_lock turns(turns_mutex_);
  std::mutex& turn = turns_[hash];
  turns.unlock();
  const std::lock_guard own_turn(turn);
  // An object that was compiled without a sandbox may hold anything, and is not kept.
  if (toolchain_.isolated())
    if (const std::optional<KeptObject> found = read_kept(kept)) {
      mark_as_used(kept);
      std::ofstream(object, std::ios::binary) << found->object;
      fs::permissions(object, fs::perms(0755));
      return {object, own_warnings(found->log, exercise.file), found->log, 0, found->cpu_seconds};
    }

  const Compiled first = run_compiler(exercise, source, job, cpu_seconds);
  if (first.object.empty()) return first;
  Compiled compiled = run_linker(exercise, job, cpu_seconds - first.cpu_seconds);
  compiled.log = first.log + compiled.log;
  if (!compiled.object.empty()) compiled.messages = own_warnings(compiled.log, exercise.file);
  compiled.made_in_seconds = compiled.cpu_seconds += first.cpu_seconds;
  if (toolchain_.isolated() && !compiled.object.empty()) {
    const fs::path file = job / "to-keep";
    std::ofstream(file, std::ios::binary)
        << text_of({hair::bytes_of(compiled.object), compiled.log, compiled.cpu_seconds});
    keep_copy(file, kept);
    std::error_code ignored;
    fs::remove(file, ignored);
    shrink_cache(cache_, kCacheBytes);
  }
  return compiled;
}

std::string Compiler::key(const Exercise& exercise, const std::string& source) const {
  std::string all =
      toolchain_.kit().hash() + '\0' + toolchain_.version() + '\0' + exercise.id + '\0' + exercise.file;
  for (const auto* words : {&exercise.libraries, &exercise.prerequisites})
    for (const std::string& word : *words) all += '\0' + word;
  return sha256(all + '\0' + source);
}

Compiled Compiler::run_compiler(const Exercise& exercise, const std::string& source, const fs::path& job,
                                double cpu_seconds) const {
  const fs::path in = source_folder(job / "source", exercise.file, source),
                 out = writable_folder(job / "object");

  double taken = 0;
  Sandbox sandbox;
  auto run = [&](bool precompiled, bool& used) {
    sandbox = toolchain_.compiling(exercise.libraries, cpu_seconds - taken, in, out);
    std::vector<std::string> command = toolchain_.compile_command(exercise.libraries);
    used = precompiled && precompiled_.use(exercise.libraries, sandbox, command);
    command.insert(command.end(), {"-c", exercise.file, "-o", "/out/object.o"});
    Toolchain::Run found = toolchain_.run(sandbox, command, exercise.file);
    taken += found.cpu_seconds;
    return found;
  };
  bool used = false;
  Toolchain::Run found = run(true, used);
  if (used && !found.ending.well() && !found.limited) found = run(false, used);

  Compiled compiled{{}, own_messages(found.output, exercise.file), found.output, taken};
  if (found.ending.well()) {
    compiled.object = out / "object.o";
    return compiled;
  }
  toolchain_.prove_it_compiles(sandbox);
  if (const std::string wide = told_if_wide(source, exercise.file); !wide.empty())
    compiled.messages = wide;
  else
    compiled.messages += told_of_stray_byte(source, exercise.file);
  if (compiled.messages.empty())
    compiled.messages = found.limited
                            ? "the compiler gave up on the file: it takes more time or memory than there is\n"
                            : "the compiler gave up on the file, with no word about its own lines\n";
  return compiled;
}

Compiled Compiler::run_linker(const Exercise& exercise, const fs::path& job, double cpu_seconds) const {
  constexpr std::size_t kLargestObject = 8 << 20;
  const fs::path out = writable_folder(job / "linked");
  Sandbox sandbox = toolchain_.linking(cpu_seconds);
  sandbox.mounts.push_back({job / "object", "/object"});
  sandbox.mounts.push_back({out, "/out", true});
  sandbox.mounts.push_back({toolchain_.kit().folder() / "export" / (exercise.id + ".map"), "/export.map"});
  std::vector<std::string> command = toolchain_.link_command();
  // Other exercises' objects find it under its name when all run together.
  command.insert(command.end(), {"-Wl,-soname," + exercise.id + ".so", "-Wl,--version-script=/export.map",
                                 "-o", "/out/" + exercise.id + ".so", "/object/object.o"});
  for (const std::string& id : exercise.prerequisites) {
    sandbox.mounts.push_back(
        {toolchain_.kit().folder() / "provided" / (id + ".so"), "/provided/" + id + ".so"});
    command.push_back("/provided/" + id + ".so");
  }
  sandbox.mounts.push_back({toolchain_.kit().folder() / "given", "/given"});
  for (const std::string& library : exercise.libraries) command.push_back("/given/" + library + ".a");
  command.push_back("/given/standard.a");

  const Toolchain::Run found = toolchain_.run(sandbox, command, exercise.file);
  Compiled compiled{{}, {}, found.output, found.cpu_seconds};
  if (!found.ending.well()) {
    toolchain_.prove_it_links(sandbox);
    const std::string names = undefined_names(found.output);
    compiled.messages =
        "the file compiles, but does not link: neither it, nor the exercises that it needs, nor the given "
        "code "
        "that it may call defines" +
        (names.empty() ? " a function that it uses\n" : "\n" + names);
    return compiled;
  }
  // This is a copy, since the sandbox's user could still change its own files.
  const std::optional<std::string> object = read_written(out / (exercise.id + ".so"), kLargestObject);
  if (!object) {
    compiled.messages = "the file compiles to something far larger than an exercise\n";
    return compiled;
  }
  compiled.object = job / (exercise.id + ".so");
  std::ofstream(compiled.object, std::ios::binary) << *object;
  fs::permissions(compiled.object, fs::perms(0755));
  return compiled;
}

bool PrecompiledHeader::use(const std::vector<std::string>& libraries, Sandbox& sandbox,
                            std::vector<std::string>& command) const {
  if (libraries != kHeaderLibraries) return false;
  std::call_once(made_, [this] { make(); });
  if (folder_.empty()) return false;
  sandbox.mounts.push_back({folder_, "/precompiled"});
  command.insert(command.end(), {"-include", "/precompiled/given.h"});
  return true;
}

void PrecompiledHeader::make() const {
  const fs::path folder = toolchain_.kit().new_job("precompiled");
  const fs::path file = folder / "given.h.gch";
  std::ofstream(folder / "given.h") << kHeaderText;
  fs::permissions(folder / "given.h", fs::perms(0644));

  const fs::path cached =
      cache_ /
      ("given-" +
       sha256(toolchain_.version() + kHeaderText + sha256_of(toolchain_.kit().folder() / "handout")) +
       ".gch");
  std::error_code error;
  if (!toolchain_.isolated() || !fs::copy_file(cached, file, error)) {
    const std::optional<std::string> bytes = compile();
    if (!bytes) return;
    std::ofstream(file, std::ios::binary) << *bytes;
    if (toolchain_.isolated()) {
      // Keeps one: it is large, and fits one kit and one compiler.
      for (const auto& entry : fs::directory_iterator(cache_, error))
        if (entry.path().extension() == ".gch") fs::remove(entry.path(), error);
      keep_copy(file, cached);
    }
  }
  mark_as_used(cached);
  fs::permissions(file, fs::perms(0644));
  folder_ = folder;
}

std::optional<std::string> PrecompiledHeader::compile() const {
  const fs::path job = toolchain_.kit().new_job("precompile"),
                 in = source_folder(job / "source", "given.h", kHeaderText),
                 out = writable_folder(job / "object");
  Sandbox sandbox = toolchain_.compiling(kHeaderLibraries, kHeaderSeconds, in, out);
  sandbox.limits.file_bytes = kHeaderBytes;
  std::vector<std::string> command = toolchain_.compile_command(kHeaderLibraries);
  command.insert(command.end(), {"-x", "c++-header", "given.h", "-o", "/out/given.h.gch"});
  const Toolchain::Run run = toolchain_.run(sandbox, command, "given.h");
  std::optional<std::string> bytes =
      run.ending.well() ? read_written(out / "given.h.gch", kHeaderBytes) : std::nullopt;
  std::error_code ignored;
  fs::remove_all(job, ignored);
  return bytes;
}

}  // namespace grader::compile
