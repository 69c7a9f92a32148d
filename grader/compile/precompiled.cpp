// STAFF ONLY. Makes the precompiled header of the given headers, in a sandbox, or takes it from the cache.
#include "grader/compile/precompiled.h"

#include <fstream>

#include "grader/compile/cache.h"
#include "grader/compile/hash.h"

namespace grader::inline compile {
namespace {

namespace fs = std::filesystem;

constexpr double kMostSeconds = 300;  // is CPU time
constexpr std::size_t kMostBytes = std::size_t{512} << 20;
const std::vector<std::string> kLibraries = {"eigen"};

constexpr const char* kText = "#include \"particles/usual.h\"\n";

}  // namespace

bool PrecompiledHeader::use(const std::vector<std::string>& libraries, Sandbox& sandbox,
                            std::vector<std::string>& command) const {
  if (libraries != kLibraries) return false;
  std::call_once(made_, [this] { make(); });
  if (folder_.empty()) return false;
  sandbox.mounts.push_back({folder_, "/precompiled"});
  command.insert(command.end(), {"-include", "/precompiled/given.h"});
  return true;
}

void PrecompiledHeader::make() const {
  const fs::path folder = toolchain_.kit().new_job("precompiled");
  const fs::path file = folder / "given.h.gch";
  std::ofstream(folder / "given.h") << kText;
  fs::permissions(folder / "given.h", fs::perms(0644));

  const fs::path cached =
      cache_ /
      ("given-" + sha256(toolchain_.version() + kText + sha256_of(toolchain_.kit().folder() / "handout")) +
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
                 in = source_folder(job / "source", "given.h", kText), out = writable_folder(job / "object");
  Sandbox sandbox = toolchain_.compiling(kLibraries, kMostSeconds, in, out);
  sandbox.limits.file_bytes = kMostBytes;
  std::vector<std::string> command = toolchain_.compile_command(kLibraries);
  command.insert(command.end(), {"-x", "c++-header", "given.h", "-o", "/out/given.h.gch"});
  const Toolchain::Run run = toolchain_.run(sandbox, command, "given.h");
  std::optional<std::string> bytes =
      run.ending.well() ? read_written(out / "given.h.gch", kMostBytes) : std::nullopt;
  std::error_code ignored;
  fs::remove_all(job, ignored);
  return bytes;
}

}  // namespace grader::compile
