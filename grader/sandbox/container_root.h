// STAFF ONLY. The root folder of a sandbox where nothing can be mounted. Files are links, or copies where
// links can't be made; writable folders are moved in, and come back.
//
//   ROOTS/system/   copies of what sandboxes need of the system, made once: links to the system's own files would share owner and mode
//   ROOTS/KEY-0     a root folder with the system's part of some sandbox; others with the same part use it after that sandbox, KEY-1 beside it
#pragma once

#include <filesystem>
#include <vector>

#include "grader/sandbox/cage.h"
#include "grader/sandbox/descriptor.h"
#include "grader/sandbox/identity.h"

namespace grader::inline sandbox {

class ContainerRoot {
 public:
  // For a run as `user`, who gets the writable folders and /tmp. Throws std::filesystem::filesystem_error.
  ContainerRoot(const Cage& cage, const Identity& user);
  ContainerRoot(const ContainerRoot&) = delete;
  ContainerRoot& operator=(const ContainerRoot&) = delete;
  // Takes all back that is not the system's. Nobody may run there any more.
  ~ContainerRoot();

  const std::filesystem::path& path() const { return path_; }

 private:
  void take_root(const std::vector<Mount>& lasting);
  void add_folder(const std::filesystem::path& folder, bool lasting);
  void add(const std::filesystem::path& source, const std::string& target, bool lasting);
  void lend(const Mount& mount, const Identity& user);

  std::filesystem::path roots_, path_;
  Descriptor lock_;                          // held while the root is in use
  std::vector<std::filesystem::path> made_;  // what goes with this run, folders before what they hold
  std::vector<Mount> lent_;
};

}  // namespace grader::sandbox
