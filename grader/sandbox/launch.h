// STAFF ONLY. What a new process does between fork and exec, so that the program in it finds what it shall
// and nothing else of ours.
#pragma once

#include <linux/filter.h>

#include <vector>

#include "grader/sandbox/identity.h"

namespace grader::inline sandbox {

struct Launch {
  // Descriptors of the program in its sandbox. bwrap writes of its child to kInfo, and reads a filter from
  // kFilter.
  enum : int { kRequests = 3, kReplies = 4, kInfo = 5, kFilter = 6 };

  std::vector<char*> argv, environment;  // each ends with a null
  std::vector<int> joins;                // open cgroup.procs files
  const char* root = nullptr;            // becomes the root folder; null: stays. Needs root's rights
  const char* folder = nullptr;          // the current folder; null: stays
  int requests = -1, replies = -1, output = -1, info = -1, filter_file = -1;
  Identity identity = {};
  std::vector<sock_filter> filter = {};  // of system calls; empty: none
  bool own_session = false;              // without a terminal, and first in line when memory runs out

  // Makes system calls only, for other threads may hold any lock.
  [[noreturn]] void exec() const;
};

}  // namespace grader::sandbox
