// STAFF ONLY. What one core of this machine can do at most, to compare the engine with.
#pragma once

namespace hair_bench {

// Operations per second of CPU time, a product and a sum counted as two: independent chains of them, with the best
// vectors that the engine may use now.
double arithmetic_peak();

// Bytes per second of CPU time that a = b + s c moves, of arrays that no cache holds; what it reads to overwrite is counted. Source: J. D.
// McCalpin, "Memory Bandwidth and Machine Balance in Current High Performance Computers" (IEEE TCCA Newsletter, 1995).
double bandwidth();

}  // namespace hair_bench
