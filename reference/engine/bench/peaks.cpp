// STAFF ONLY.
#define HWY_BROKEN_EMU128 1
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SSE4 | HWY_SSSE3)

#include "reference/engine/bench/peaks.h"

#include <algorithm>
#include <vector>

#include "solver/timing.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "reference/engine/bench/peaks.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hair_bench::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Four cycles until a product is there, times two a cycle: eight chains at least.
double chains() {
  constexpr int kTurns = 200'000, kChains = 8;
  using Tag = hn::CappedTag<double, 8>;
  const double start = timing::cpu_seconds();
  auto a = hn::Iota(Tag(), 1), b = hn::Iota(Tag(), 2), c = hn::Iota(Tag(), 3), d = hn::Iota(Tag(), 4),
       e = hn::Iota(Tag(), 5), f = hn::Iota(Tag(), 6), g = hn::Iota(Tag(), 7), h = hn::Iota(Tag(), 8);
  const auto s = hn::Set(Tag(), 0.999), t = hn::Set(Tag(), 1e-3);
  for (int turn = 0; turn < kTurns; ++turn) {
    a = hn::MulAdd(a, s, t);
    b = hn::MulAdd(b, s, t);
    c = hn::MulAdd(c, s, t);
    d = hn::MulAdd(d, s, t);
    e = hn::MulAdd(e, s, t);
    f = hn::MulAdd(f, s, t);
    g = hn::MulAdd(g, s, t);
    h = hn::MulAdd(h, s, t);
  }
  const double sum = hn::GetLane(hn::SumOfLanes(Tag(), ((a + b) + (c + d)) + ((e + f) + (g + h))));
  const double seconds = timing::cpu_seconds() - start;
  // The sum is needed so that the loop is.
  return sum == 0 ? 0 : 2.0 * kTurns * kChains * static_cast<double>(hn::Lanes(Tag())) / seconds;
}

}  // namespace hair_bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hair_bench {

HWY_EXPORT(chains);

double arithmetic_peak() {
  double most = 0;
  for (int i = 0; i < 20; ++i) most = std::max(most, HWY_DYNAMIC_DISPATCH(chains)());
  return most;
}

double bandwidth() {
  constexpr std::size_t kNumbers = 16'000'000;
  std::vector<double> a(kNumbers, 1), b(kNumbers, 2), c(kNumbers, 3);
  double most = 0;
  for (int i = 0; i < 5; ++i) {
    const double start = timing::cpu_seconds();
    for (std::size_t k = 0; k < kNumbers; ++k) a[k] = b[k] + 1e-3 * c[k];
    most = std::max(most, 4 * sizeof(double) * kNumbers / (timing::cpu_seconds() - start));
    std::swap(a, b);
  }
  return most;
}

}  // namespace hair_bench
#endif
