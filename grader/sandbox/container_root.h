// STAFF ONLY. The root folder of a sandbox where nothing can be mounted. Files are links, or copies where
// links can't be made; writable folders are moved in, and come back.
//
// ROOTS/system/ holds copies of system files: links would share their owner and mode.
// ROOTS/KEY-0 is a root folder with system files; sandboxes that need the same ones use it in turn, or KEY-1.
#pragma once

#include <filesystem>
#include <vector>

#include "grader/sandbox/processes/descriptor.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/sandbox.h"

namespace grader::inline sandbox {

class ContainerRoot {
 public:
  // Prepares a run as `user`, who gets writable folders and /tmp. Throws std::filesystem::filesystem_error.
  ContainerRoot(const Sandbox& sandbox, const Identity& user);
  ContainerRoot(const ContainerRoot&) = delete;
  ContainerRoot& operator=(const ContainerRoot&) = delete;
  // Takes back everything but the system files. No process may run there any more.
  ~ContainerRoot();

  const std::filesystem::path& path() const { return path_; }

 private:
  void take_root(const std::vector<Mount>& lasting);
  void add_folder(const std::filesystem::path& folder, bool lasting);
  void add(const std::filesystem::path& source, const std::string& target, bool lasting);
  void lend(const Mount& mount, const Identity& user);

  std::filesystem::path roots_, path_;
  Descriptor lock_;                          // held while the root is in use
  std::vector<std::filesystem::path> made_;  // goes with this run; folders stand before their contents
  std::vector<Mount> lent_;
};

}  // namespace grader::sandbox
