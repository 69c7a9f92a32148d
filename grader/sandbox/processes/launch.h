// STAFF ONLY. Prepares a new process between fork and exec: the program finds what it needs, and nothing
// else of ours.
#pragma once

#include <linux/filter.h>

#include <vector>

#include "grader/sandbox/processes/identity.h"

namespace grader::inline sandbox {

struct Launch {
  // These descriptors belong to the program in its sandbox. bwrap writes about its child to kInfo, and reads
  // a filter from kFilter.
  enum : int { kRequests = 3, kReplies = 4, kInfo = 5, kFilter = 6 };

  std::vector<char*> argv, environment;  // both end with a null
  std::vector<int> joins;                // are open cgroup.procs files
  const char* root = nullptr;            // becomes the root folder; null: no change. Needs root's rights
  const char* folder = nullptr;          // becomes the current folder; null: no change
  int requests = -1, replies = -1, output = -1, info = -1, filter_file = -1;
  Identity identity = {};
  std::vector<sock_filter> filter = {};  // stops system calls; empty: stops none
  bool own_session = false;              // no terminal, and ended first when memory runs out

  // Makes system calls only, since other threads may hold any lock.
  [[noreturn]] void exec() const;
};

}  // namespace grader::sandbox
