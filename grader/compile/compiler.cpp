// STAFF ONLY.
#include "grader/compile/compiler.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "grader/compile/hash.h"
#include "grader/course/bad_input.h"
#include "grader/sandbox/cage.h"
#include "grader/sandbox/identity.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOutput = 64 << 10;

const std::vector<std::string> kCompile = {"-std=c++20",
                                           "-O2",
                                           "-fPIC",
                                           "-ffp-contract=off",
                                           "-pipe",
                                           "-fmax-errors=20",
                                           "-fno-diagnostics-show-caret",
                                           "-fdiagnostics-color=never",
                                           "-c"};
const std::vector<std::string> kLink = {"-shared",     "-s",        "-fno-lto", "-fno-use-linker-plugin",
                                        "-Wl,-z,defs", "-Wl,-z,now"};

std::string find_compiler() {
  for (const char* name : {"/usr/bin/g++", "/usr/bin/c++", "/usr/bin/clang++"})
    if (fs::exists(name)) return fs::canonical(name).string();
  throw BadInput("no C++ compiler in /usr/bin; install g++");
}

Cage toolchain_cage(bool isolated) {
  Cage cage;
  cage.mounts = toolchain_mounts();
  cage.tmp_bytes = 64 << 20;
  cage.syscalls = Syscalls::toolchain;
  cage.limits.memory_bytes = std::size_t{2} << 30;
  cage.limits.cpu_seconds = 15;
  cage.isolated = isolated;
  return cage;
}

struct Run {
  Ending ending;
  std::string output;
};

// True if the tool itself, and not a message about the student's own lines, which may quote anything, says
// one of these.
bool tool_says(const std::string& log, const std::string& student_file,
               std::initializer_list<const char*> sayings) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with(student_file + ":"))
      for (const char* saying : sayings)
        if (line.find(saying) != std::string::npos) return true;
  return false;
}

Run run(const Cage& cage, const std::vector<std::string>& command, const std::string& student_file) {
  Pipe output = make_pipe();
  const std::vector<std::string> limited = cage.isolated ? with_inner_limits(cage.limits, command) : command;
  CagedProcess process(cage, limited, -1, -1, output.write_end.get());
  output.write_end.close();
  std::string text = read_all(output.read_end, kMostOutput, cage.limits.wall_seconds);
  const bool flood = text.size() >= kMostOutput;
  // It may still run: out of time, or with more to say than anybody reads.
  const Ending ending = process.wait(flood ? 0 : 1);
  // What keeps a compiler from starting is the machine's fault, and no student's.
  if (ending.code == 126 || ending.code == 127 ||
      tool_says(text, student_file, {"cannot execute", "Resource temporarily unavailable"}))
    throw std::runtime_error("the compiler could not run: " + text.substr(0, 500));
  // Which limit a bomb meets first differs from run to run; that it met one does not.
  if (flood ||
      tool_says(text, student_file, {"Killed signal", "memory exhausted", "out of memory", "CPU time limit"}))
    text = "a limit on time, memory or output was reached\n";
  return {ending, std::move(text)};
}

// What the tool wrote; nothing if that is no plain file, or larger than any exercise's. Not through a link,
// which it could have left.
std::optional<std::string> read_written(const fs::path& path) {
  constexpr off_t kMost = 8 << 20;
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status = {};
  if (!file || fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_size > kMost)
    return {};
  return read_all(file, kMost, 10);
}

// Where the headers of an exercise's libraries are, in /usr/include.
std::vector<std::string> header_folders(std::vector<std::string> libraries) {
  std::replace(libraries.begin(), libraries.end(), std::string("eigen"), std::string("eigen3"));
  return libraries;
}

fs::path writable_folder(const fs::path& path) {
  fs::create_directory(path);
  share_with_sandbox(path, true);
  return path;
}

}  // namespace

Compiler::Compiler(const StagedKit& kit, fs::path cache, bool isolated)
    : kit_(kit), cache_(std::move(cache)), isolated_(isolated), program_(find_compiler()) {
  std::error_code error;
  fs::create_directories(cache_, error);
  if (error) throw BadInput(cache_.string() + ": can't keep compiled objects there: " + error.message());
  version_ = sha256_of(program_);
}

Compiled Compiler::compile(const Exercise& exercise, const std::string& source, const fs::path& job) const {
  const fs::path object = job / (exercise.id + ".so"), cached = cache_ / (key(exercise, source) + ".so");
  std::error_code error;
  // What was compiled without a cage may hold anything, and is not kept.
  if (isolated_ && fs::copy_file(cached, object, error)) {
    fs::permissions(object, fs::perms(0755));
    return {object, {}, {}};
  }

  Compiled compiled = run_compiler(exercise, source, job);
  if (compiled.object.empty()) return compiled;
  const std::string compiler_log = std::move(compiled.log);
  compiled = run_linker(exercise, job);
  compiled.log = compiler_log + compiled.log;
  // With warnings it is compiled again the next time, so that they are there again.
  if (isolated_ && !compiled.object.empty() && compiled.log.empty()) {
    std::string temporary = (cache_ / "new-XXXXXX").string();
    const Descriptor file(mkostemp(temporary.data(), O_CLOEXEC));
    if (file && fs::copy_file(compiled.object, temporary, fs::copy_options::overwrite_existing, error))
      fs::rename(temporary, cached, error);
  }
  return compiled;
}

std::string Compiler::key(const Exercise& exercise, const std::string& source) const {
  std::string all = kit_.hash() + '\0' + version_ + '\0' + exercise.id + '\0' + exercise.file;
  for (const auto* words : {&kCompile, &kLink, &exercise.libraries, &exercise.prerequisites})
    for (const std::string& word : *words) all += '\0' + word;
  return sha256(all + '\0' + source);
}

Compiled Compiler::run_compiler(const Exercise& exercise, const std::string& source,
                                const fs::path& job) const {
  const fs::path in = job / "source", out = writable_folder(job / "object");
  fs::create_directory(in);
  share_with_sandbox(in, false);
  std::ofstream(in / exercise.file, std::ios::binary) << source;
  fs::permissions(in / exercise.file, fs::perms(0644));

  Cage cage = toolchain_cage(isolated_);
  const std::vector<std::string> libraries = header_folders(exercise.libraries);
  for (const Mount& mount : header_mounts(kit_.empty_folder(), libraries)) cage.mounts.push_back(mount);
  cage.mounts.push_back({kit_.folder() / "include", "/given"});
  cage.mounts.push_back({in, "/student"});
  cage.mounts.push_back({out, "/out", true});
  cage.folder = "/student";
  std::vector<std::string> command = {program_};
  command.insert(command.end(), kCompile.begin(), kCompile.end());
  for (const std::string& folder : libraries)
    command.insert(command.end(), {"-isystem", "/usr/include/" + folder});
  command.insert(command.end(), {"-I/given", exercise.file, "-o", "/out/object.o"});

  const auto [ending, output] = run(cage, command, exercise.file);
  Compiled compiled{ending.well() ? out / "object.o" : fs::path(), own_messages(output, exercise.file),
                    output};
  if (!ending.well() && compiled.messages.empty())
    compiled.messages =
        "the compiler gave up on the file: it takes more time or memory than there is, or names a file that "
        "is not there\n";
  return compiled;
}

Compiled Compiler::run_linker(const Exercise& exercise, const fs::path& job) const {
  const fs::path out = writable_folder(job / "linked");
  Cage cage = toolchain_cage(isolated_);
  cage.mounts.push_back({job / "object", "/object"});
  cage.mounts.push_back({out, "/out", true});
  cage.mounts.push_back({kit_.folder() / "export" / (exercise.id + ".map"), "/export.map"});
  std::vector<std::string> command = {program_};
  command.insert(command.end(), kLink.begin(), kLink.end());
  if (fs::exists("/usr/bin/ld.gold"))
    command.push_back("-fuse-ld=gold");  // a third of the default linker's time
  // Under its name other exercises' objects find it, where all run together.
  command.insert(command.end(), {"-Wl,-soname," + exercise.id + ".so", "-Wl,--version-script=/export.map",
                                 "-o", "/out/" + exercise.id + ".so", "/object/object.o"});
  for (const std::string& id : exercise.prerequisites) {
    cage.mounts.push_back({kit_.folder() / "lib" / (id + ".so"), "/lib-given/" + id + ".so"});
    command.push_back("/lib-given/" + id + ".so");
  }

  const auto [ending, output] = run(cage, command, exercise.file);
  Compiled compiled{{}, {}, output};
  if (!ending.well()) {
    compiled.messages =
        "the file compiles, but does not link: it uses a function that neither it nor its prerequisites "
        "define\n";
    return compiled;
  }
  // Copied, for the sandbox's user could still change what it has written.
  const std::optional<std::string> object = read_written(out / (exercise.id + ".so"));
  if (!object) {
    compiled.messages = "the file compiles to something far larger than an exercise\n";
    return compiled;
  }
  compiled.object = job / (exercise.id + ".so");
  std::ofstream(compiled.object, std::ios::binary) << *object;
  fs::permissions(compiled.object, fs::perms(0755));
  return compiled;
}

std::string own_messages(const std::string& log, const std::string& file) {
  std::istringstream lines(log);
  std::string own;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(file + ":")) own += line + "\n";
  return own;
}

}  // namespace grader
