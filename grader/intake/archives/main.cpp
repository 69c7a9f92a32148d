// STAFF ONLY. hairintake: reads one archive in a sandbox, for intake outside (archive_service.h).
//
//   hairintake CPU_SECONDS MEMORY_BYTES UNPACKED_BYTES ENTRIES NAME
#include <locale.h>

#include <cstdlib>
#include <string>

#include "grader/intake/archives/archive_service.h"

int main(int argc, char* argv[]) {
  using namespace grader;
  if (argc != 6) return 2;
  setlocale(LC_CTYPE, "C.UTF-8");  // names in archives may hold any letters
  const auto number = [&](int i) { return static_cast<std::size_t>(std::strtoull(argv[i], nullptr, 10)); };
  lock_reader({std::atoi(argv[1]), number(2)});
  serve_archive(argv[5], {number(3), number(4)});
  return 0;
}
