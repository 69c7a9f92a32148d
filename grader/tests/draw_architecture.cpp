// STAFF ONLY. Writes the picture of grader/ARCHITECTURE.md: draw_architecture grader/architecture.svg
#include <cstdio>

#include "grader/tests/architecture.h"
#include "hair/io/files/write_file.h"

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "draw_architecture FILE: writes the picture of grader/ARCHITECTURE.md\n");
    return 2;
  }
  hair::write_file(words[1], grader::architecture());
}
