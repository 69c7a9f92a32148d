// STAFF ONLY. Finds the files of the system's compiler and programs.
#include "grader/sandbox/system_mounts.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>
#include <sstream>

#include "grader/sandbox/processes/descriptor.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/start_program.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

// True for folders of /usr/include that belong to the C and C++ libraries.
bool is_standard(const std::string& folder) {
  static const std::set<std::string> names = {
      "c++",     "linux",   "asm-generic", "asm",       "bits",      "sys",      "gnu",       "net",
      "netinet", "arpa",    "rpc",         "protocols", "misc",      "scsi",     "sound",     "mtd",
      "rdma",    "video",   "drm",         "xen",       "netash",    "netatalk", "neteconet", "netrom",
      "netrose", "netax25", "netipx",      "netiucv",   "netpacket", "finclude", "regulator"};
  return names.count(folder) > 0 || folder.find("-linux-gnu") != std::string::npos;
}

std::vector<Mount> existing(std::initializer_list<const char*> folders) {
  std::vector<Mount> mounts;
  std::error_code error;
  for (const char* path : folders)
    if (fs::exists(path, error)) mounts.push_back({path, path});
  return mounts;
}

// Returns the output of a program of the system.
std::string answer_of(const std::vector<std::string>& words) {
  Pipe output = make_pipe();
  const pid_t process =
      hair::start_program({.words = words, .output = output.write_end.get(), .environment = {"LC_ALL=C"}});
  output.write_end.close();
  std::string said = read_all(output.read_end, 1 << 20, 60);
  hair::exit_code_of(process);
  return said;
}

// Reads lines "NAME => PATH (ADDRESS)" or "PATH (ADDRESS)".
std::set<fs::path> libraries_of(const std::vector<fs::path>& programs) {
  std::vector<std::string> words = {"/usr/bin/ldd"};
  for (const fs::path& program : programs) words.push_back(program);
  std::istringstream said(answer_of(words));
  std::set<fs::path> libraries;
  for (std::string word; said >> word;)
    if (word.front() == '/' && word.back() != ':') libraries.insert(word);
  return libraries;
}

// Collects files and folders, each in its place, with the links that lead there.
class Files {
 public:
  Files() {
    for (const char* folder : {"/bin", "/lib", "/lib64"})
      if (fs::is_symlink(folder)) mounts_.push_back({folder, folder});
  }

  void add(fs::path path) {
    for (;;) {
      path = fs::canonical(path.parent_path()) / path.filename();
      if (!fs::exists(fs::symlink_status(path)) || !added_.insert(path).second) return;
      mounts_.push_back({path, path});
      if (!fs::is_symlink(path)) return;
      path = path.parent_path() / fs::read_symlink(path);
    }
  }

  void add_libraries_of(const std::vector<fs::path>& programs) {
    for (const fs::path& library : libraries_of(programs)) add(library);
  }
  const std::vector<Mount>& mounts() const { return mounts_; }

 private:
  std::vector<Mount> mounts_;
  std::set<fs::path> added_;
};

// Reads the folders of one kind where a compiler looks: a line "KIND: =FOLDER:FOLDER...".
std::vector<fs::path> search_folders(const fs::path& compiler, const std::string& kind) {
  std::istringstream lines(answer_of({compiler.string(), "-print-search-dirs"}));
  std::vector<fs::path> folders;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(kind + ": =")) continue;
    std::istringstream words(line.substr(kind.size() + 3));
    for (std::string folder; std::getline(words, folder, ':');)
      if (fs::is_directory(folder)) folders.push_back(fs::canonical(folder));
  }
  return folders;
}

// Lists the compiler's own programs and objects, and those that it links each library with.
std::vector<Mount> files_of_toolchain() {
  const fs::path compiler = system_compiler();
  std::vector<fs::path> programs = {compiler};
  for (const char* name : {"as", "ld", "ld.bfd", "ld.gold", "addr2line", "prlimit"})
    programs.push_back(fs::path("/usr/bin") / name);
  for (const fs::path& folder : search_folders(compiler, "programs"))
    for (const char* name : {"cc1plus", "collect2"}) programs.push_back(folder / name);
  std::erase_if(programs, [](const fs::path& program) { return !fs::exists(program); });

  Files files;
  for (const fs::path& program : programs) files.add(program);
  files.add_libraries_of(programs);
  for (const fs::path& folder : search_folders(compiler, "libraries"))
    for (const char* name :
         {"crti.o", "crtn.o", "crtbeginS.o", "crtendS.o", "libgcc.a", "libgcc_eh.a", "libgcc_s.so",
          "libgcc_s.so.1", "libstdc++.so", "libm.so", "libm.so.6", "libmvec.so.1", "libc.so", "libc.so.6",
          "libc_nonshared.a", "include", "include-fixed"})
      files.add(folder / name);
  return files.mounts();
}

}  // namespace

std::vector<Mount> runtime_library_mounts() {
  std::vector<Mount> mounts;
  auto collect = [](dl_phdr_info* object, std::size_t, void* data) {
    static constexpr std::array wanted = {"libc.so",     "libm.so",       "libstdc++.so",
                                          "libgcc_s.so", "libseccomp.so", "ld-linux"};
    const std::string path = object->dlpi_name;
    const std::string file = fs::path(path).filename();
    if (std::any_of(wanted.begin(), wanted.end(), [&](const char* name) { return file.rfind(name, 0) == 0; }))
      static_cast<std::vector<Mount>*>(data)->push_back({fs::canonical(path), path});
    return 0;
  };
  dl_iterate_phdr(collect, &mounts);
  return mounts;
}

std::vector<Mount> library_mounts(Isolation kind, const std::vector<fs::path>& programs) {
  if (kind != Isolation::container) return existing({"/usr/lib", "/usr/lib64", "/lib", "/lib64"});
  Files files;
  files.add_libraries_of(programs);
  return files.mounts();
}

std::vector<Mount> program_mounts(const std::vector<fs::path>& programs) {
  Files files;
  for (const fs::path& program : programs) files.add(program);
  files.add_libraries_of(programs);
  return files.mounts();
}

std::vector<Mount> toolchain_mounts(Isolation kind) {
  if (kind == Isolation::container) return files_of_toolchain();
  std::vector<Mount> mounts = existing({"/usr/bin", "/usr/libexec", "/bin", "/etc/alternatives"});
  for (const Mount& mount : library_mounts(kind, {})) mounts.push_back(mount);
  return mounts;
}

std::vector<Mount> header_mounts(Isolation kind, const fs::path& empty_folder,
                                 const std::vector<std::string>& folders) {
  std::vector<Mount> mounts;
  if (kind != Isolation::container) mounts.push_back({"/usr/include", "/usr/include"});
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator("/usr/include", error)) {
    const std::string name = entry.path().filename();
    const bool hidden = entry.is_directory(error) && !entry.is_symlink(error) && !is_standard(name) &&
                        std::ranges::find(folders, name) == folders.end();
    if (kind == Isolation::container && !hidden) mounts.push_back({entry.path(), entry.path()});
    if (kind != Isolation::container && hidden) mounts.push_back({empty_folder, entry.path()});
  }
  return mounts;
}

fs::path system_compiler() {
  for (const char* name : {"/usr/bin/g++", "/usr/bin/c++", "/usr/bin/clang++"})
    if (fs::exists(name)) return fs::canonical(name);
  throw hair::BadInput("no C++ compiler in /usr/bin; install g++");
}

}  // namespace grader::sandbox
