// STAFF ONLY.
#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>

#include "grader/sandbox/cage.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

// Folders of /usr/include that belong to the C and C++ libraries.
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

std::vector<Mount> library_mounts() {
  return existing({"/usr/lib", "/usr/lib64", "/lib", "/lib64"});
}

std::vector<Mount> toolchain_mounts() {
  std::vector<Mount> mounts = existing({"/usr/bin", "/usr/libexec", "/bin", "/etc/alternatives"});
  for (const Mount& mount : library_mounts()) mounts.push_back(mount);
  return mounts;
}

std::vector<Mount> header_mounts(const fs::path& empty_folder, const std::vector<std::string>& folders) {
  std::vector<Mount> mounts = {{"/usr/include", "/usr/include"}};
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator("/usr/include", error)) {
    const std::string name = entry.path().filename();
    if (entry.is_directory(error) && !entry.is_symlink(error) && !is_standard(name) &&
        std::find(folders.begin(), folders.end(), name) == folders.end())
      mounts.push_back({empty_folder, entry.path().string()});
  }
  return mounts;
}

}  // namespace grader
