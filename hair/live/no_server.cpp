// Replaces hairlab-live in a build without the library that serves pages.
#include <iostream>

int main() {
  std::cerr << "hairlab: live needs a package that was missing when hairlab was configured. "
            << HAIR_HOW_TO_INSTALL << ". Then configure again: cmake -S . -B build\n";
  return 2;
}
