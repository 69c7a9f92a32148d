// STAFF ONLY. What a step of the engine costs and how far off it is; beside given code, Bullet's rope and plain XPBD. Prints Markdown.
// Usage: engine_bench [STRANDS].

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "reference/engine/bench/bench_head.h"
#include "reference/engine/bench/tables.h"

int main(int count, char** arguments) {
  using namespace hair_bench;
  const int strands = count > 1 ? std::atoi(arguments[1]) : 20'000;
  if (strands < 1) {
    std::fprintf(stderr, "engine_bench: STRANDS is \"%s\"; it must be a number of at least 1\n",
                 arguments[1]);
    return 2;
  }
  const hair::Groom grown = combed_groom(std::min(strands, 20'000));
  by_parts(strands, grown);
  by_strands(grown);
  by_set(strands, grown);
  by_peaks();
  by_step(grown);
  beside_others();
  by_precision();
  by_curves();
}
