// `hairlab live`: a server for a page, and a process that runs a scene for it (runner.h). If that process
// fails in any way, page and server stay.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "hair/live/program_file.h"

namespace hair {

struct LiveOptions {
  std::string name, shows;         // the scene's name and its one line
  int port = 0;                    // 0: any free port
  std::vector<std::string> words;  // the command of the process that runs the scene
};

// Serves until `interrupted`. Prints the page's address when it can be opened. Throws BadInput if the port is
// taken.
void serve_live(const LiveOptions& options, ProgramFile program, const std::atomic<bool>& interrupted);

}  // namespace hair
