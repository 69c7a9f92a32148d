// STAFF ONLY. Holds the options of compiler and linker, and starts them in their sandboxes.
#include "grader/compile/toolchain.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/sandboxed_process.h"
#include "grader/sandbox/system_mounts.h"

namespace grader::inline compile {
namespace {
namespace fs = std::filesystem;

constexpr std::size_t kMostOutput = 64 << 10;  // bounds a compiler's output
constexpr double kLeastSeconds = 0.05;         // is left when a share is used up

const std::vector<std::string> kCompile = {"-std=c++20", "-O3", "-fPIC", "-ffp-contract=off", "-pipe",
                                           "--param=ggc-min-heapsize=524288",  // kB: collects no garbage
                                           "-frandom-seed=exercise",
                                           // A student's build has them (handout/cmake/exercises.cmake).
                                           "-ftrivial-auto-var-init=pattern", "-Wall", "-Wextra",
                                           "-fmax-errors=20", "-fno-diagnostics-show-caret",
                                           "-fdiagnostics-color=never"};
const std::vector<std::string> kLink = {"-shared",     "-s",        "-fno-lto", "-fno-use-linker-plugin",
                                        "-Wl,-z,defs", "-Wl,-z,now"};

// Returns its headers' folder, below /usr/include.
std::string folder_of(const std::string& library) {
  return library == "eigen" ? "eigen3" : library;
}

// True if the tool itself prints one of these, and not a message about the student's own lines, which may
// quote anything.
bool tool_says(const std::string& log, const std::string& student_file,
               std::initializer_list<const char*> sayings) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with(student_file + ":"))
      for (const char* saying : sayings)
        if (line.find(saying) != std::string::npos) return true;
  return false;
}

}  // namespace

Toolchain::Toolchain(const StagedKit& kit, Isolation isolation)
    : kit_(kit), isolation_(isolation), program_(system_compiler()), system_(toolchain_mounts(isolation)) {
  std::string all = sha256_of(program_);
  for (const auto* words : {&kCompile, &kLink})
    for (const std::string& word : *words) all += '\0' + word;
  version_ = sha256(all);
}

Toolchain::Run Toolchain::run(const Sandbox& sandbox, const std::vector<std::string>& command,
                              const std::string& file) const {
  Pipe output = make_pipe();
  const std::vector<std::string> limited = isolated() ? with_inner_limits(sandbox.limits, command) : command;
  SandboxedProcess process(sandbox, limited, -1, -1, output.write_end.get());
  output.write_end.close();
  Run run{{}, read_both_ends(output.read_end, kMostOutput, sandbox.limits.wall_seconds)};
  run.ending = process.wait(1);
  run.cpu_seconds = run.ending.cpu_seconds;
  run.limited =
      run.ending.timed_out || run.ending.out_of_memory ||
      run.cpu_seconds >= sandbox.limits.cpu_seconds_of_all ||
      tool_says(run.output, file, {"Killed signal", "memory exhausted", "out of memory", "CPU time limit"});
  // A bomb may meet another limit in each run, but it always meets one.
  if (run.limited && !run.ending.well()) run.output = "a limit on time or memory was reached\n";
  return run;
}

void Toolchain::prove(Sandbox sandbox, const std::vector<std::string>& command) const {
  sandbox.limits.cpu_seconds_of_all = sandbox.limits.cpu_seconds =
      10;  // ignores the rest of the file's share
  const Run control = run(sandbox, command, "/dev/null");
  if (!control.ending.well())
    throw std::runtime_error("the compiler could not run: " + printable(control.output.substr(0, 500)));
}

void Toolchain::prove_it_compiles(const Sandbox& sandbox) const {
  std::vector<std::string> command = {program_};
  command.insert(command.end(), kCompile.begin(), kCompile.end());
  command.insert(command.end(), {"-x", "c++", "-c", "-", "-o", "/tmp/nothing.o"});
  prove(sandbox, command);
}

void Toolchain::prove_it_links(const Sandbox& sandbox) const {
  std::vector<std::string> command = link_command();
  command.insert(command.end(), {"-nostdlib", "-o", "/tmp/nothing.so", "-Wl,--version"});
  prove(sandbox, command);
}

Sandbox Toolchain::linking(double cpu_seconds) const {
  Sandbox sandbox;
  sandbox.mounts = system_;
  sandbox.tmp_bytes = 64 << 20;
  sandbox.syscalls = Syscalls::toolchain;
  sandbox.limits.memory_bytes = std::size_t{2} << 30;
  sandbox.limits.cpu_seconds_of_all = std::max(kLeastSeconds, cpu_seconds);
  sandbox.limits.cpu_seconds = static_cast<int>(std::ceil(sandbox.limits.cpu_seconds_of_all));
  sandbox.limits.wall_seconds = 600;  // compilers do not sleep, but machines are busy
  sandbox.isolation = isolation_;
  sandbox.roots = kit_.roots();
  return sandbox;
}

Sandbox Toolchain::compiling(const std::vector<std::string>& libraries, double cpu_seconds) const {
  Sandbox sandbox = linking(cpu_seconds);
  std::vector<std::string> folders;
  for (const std::string& library : libraries) folders.push_back(folder_of(library));
  for (const Mount& mount : header_mounts(isolation_, kit_.empty_folder(), folders))
    sandbox.mounts.push_back(mount);
  sandbox.mounts.push_back({kit_.folder() / "handout", "/handout"});
  return sandbox;
}

Sandbox Toolchain::compiling(const std::vector<std::string>& libraries, double cpu_seconds,
                             const fs::path& in, const fs::path& out) const {
  Sandbox sandbox = compiling(libraries, cpu_seconds);
  sandbox.mounts.push_back({in, kStudentFolder});
  sandbox.mounts.push_back({out, "/out", true});
  sandbox.folder = kStudentFolder;
  return sandbox;
}

std::vector<std::string> Toolchain::compile_command(const std::vector<std::string>& libraries) const {
  std::vector<std::string> command = {program_};
  command.insert(command.end(), kCompile.begin(), kCompile.end());
  for (const std::string& library : libraries)
    command.insert(command.end(), {"-isystem", "/usr/include/" + folder_of(library)});
  // A student's build has this order.
  command.insert(command.end(),
                 {"-I/handout/solver/lecture", "-I/handout/given", "-I/handout", "-I/handout/given/student"});
  return command;
}

std::vector<std::string> Toolchain::link_command() const {
  std::vector<std::string> command = {program_};
  command.insert(command.end(), kLink.begin(), kLink.end());
  if (fs::exists("/usr/bin/ld.gold"))
    command.emplace_back("-fuse-ld=gold");  // takes a third of the default linker's time
  return command;
}

fs::path source_folder(const fs::path& path, const std::string& name, const std::string& text) {
  fs::create_directory(path);
  share_with_sandbox(path, false);
  std::ofstream(path / name, std::ios::binary) << text;
  fs::permissions(path / name, fs::perms(0644));
  fs::last_write_time(path / name, fs::file_time_type());
  return path;
}

fs::path writable_folder(const fs::path& path) {
  fs::create_directory(path);
  share_with_sandbox(path, true);
  return path;
}

std::optional<std::string> read_written(const fs::path& path, std::size_t most) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status = {};
  if (!file || fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode) ||
      status.st_size > static_cast<off_t>(most))
    return {};
  return read_all(file, most, 10);
}

StagedKit::StagedKit(const fs::path& kit, const Course& course) {
  std::vector<fs::path> parts = {"probe", "worker", "serve/runs.so", "given/standard.a"};
  for (const Exercise& exercise : course.exercises) {
    parts.push_back(fs::path("handout") / exercise.header);
    parts.push_back(fs::path("export") / (exercise.id + ".map"));
    for (const char* folder : {"lib", "stub", "serve"})
      parts.push_back(fs::path(folder) / (exercise.id + ".so"));
    for (const std::string& library : exercise.libraries)
      parts.push_back(fs::path("given") / (library + ".a"));
    for (const std::string& id : exercise.prerequisites) parts.push_back(fs::path("provided") / (id + ".so"));
  }
  for (const fs::path& part : parts)
    if (!fs::exists(kit / part))
      throw BadInput((kit / part).string() + " is missing; build the target grading_kit");

  fs::copy(kit, folder(), fs::copy_options::recursive);
  fs::create_directory(empty_folder());
  fs::permissions(empty_folder(), fs::perms(0755));
  for (const auto& entry : fs::recursive_directory_iterator(folder()))
    fs::permissions(entry.path(), fs::perms(0755));
  fs::permissions(folder(), fs::perms(0755));
  hash_ = sha256_of(folder());
}

fs::path StagedKit::new_job(const std::string& name) const {
  const fs::path job = root_.path() / name;
  fs::create_directory(job);
  share_with_sandbox(job, false);
  return job;
}

}  // namespace grader::compile
