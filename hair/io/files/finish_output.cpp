#include "hair/io/files/finish_output.h"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <system_error>

namespace hair {

void begin_output() {
  for (int number = 0; number < 3; ++number)
    if (fcntl(number, F_GETFD) < 0) open("/dev/null", O_RDONLY);  // gets the lowest free number
}

int finish_output(const std::string& program, int code) {
  errno = 0;
  const bool flushed = std::cout.flush().good(), written = std::fflush(stdout) == 0;
  if (flushed && written && std::ferror(stdout) == 0) return code;
  if (errno == 0) {  // the earlier error left no reason: another write asks for it
    std::clearerr(stdout);
    std::fputc('\n', stdout);
    std::fflush(stdout);
  }
  std::cerr << program << ": the standard output can't be written"
            << (errno != 0 ? " (" + std::generic_category().message(errno) + ")" : "")
            << ", so that results are lost; send it to a place with room in it\n";
  return code == 0 ? 2 : code;
}

}  // namespace hair
