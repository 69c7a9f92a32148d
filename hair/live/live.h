// `hairlab live`: a server for a page, and a process that plays for it (player.h). Whatever happens to that
// process, page and server stay.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "hair/live/program_file.h"

namespace hair {

struct LiveOptions {
  std::string name, shows;         // of the scene
  int port = 0;                    // 0: one that is free
  std::vector<std::string> words;  // of the process that plays
};

// Until `interrupted`. Prints the page's address when it can be opened. Throws BadInput if the port is taken.
void serve_live(const LiveOptions& options, ProgramFile program, const std::atomic<bool>& interrupted);

}  // namespace hair
