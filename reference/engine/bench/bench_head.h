// STAFF ONLY. The head of hair that the engine's benchmark steps, and the time that it takes.
#pragma once

#include <functional>

#include "hair/head/full_head.h"
#include "hair/head/groom.h"
#include "solver/timing.h"

namespace hair_bench {

inline constexpr int kPoints = 25;
inline constexpr double kStep = 1.0 / 24;  // s
inline constexpr int kWarmUp = 4, kSteps = 6;

// Hair on the bust, combed. Neighbours follow each other.
hair::Groom combed_groom(int strands);

// The strands of `head` take the groom's in turn.
void set(hair::FullHead& head, const hair::Groom& groom);

hair::FullHeadSettings with(bool bending, bool correction, bool contact);

// Seconds: the least of some times.
double least(int times, const std::function<void()>& work, double (*clock)() = timing::process_cpu_seconds);

// ns per particle and step, of CPU time if the clock says so. Says how many bytes a particle takes, if `bytes` is not null.
double engine_ns(const hair::FullHeadSettings& settings, int strands, const hair::Groom& groom,
                 double (*clock)() = timing::process_cpu_seconds, double* bytes = nullptr);

}  // namespace hair_bench
