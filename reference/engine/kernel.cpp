// STAFF ONLY. The kernels, compiled for each instruction set that Highway has here: AVX-512, AVX2, and,
// without vectors, for any processor.
#define HWY_BROKEN_EMU128 1  // without vectors means scalars
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SSE4 | HWY_SSSE3)

#include "reference/engine/group.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "reference/engine/kernel.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h

#include "reference/engine/contact.h"
#include "reference/engine/lanes.h"
#include "reference/engine/lengths.h"
#include "reference/engine/solve_bending.h"

HWY_BEFORE_NAMESPACE();
namespace hair::engine::HWY_NAMESPACE {

template <bool kBend, bool kCorrect, bool kContact>
void step_group(const StepConstants& step, const Group& group, const Scratch& scratch) {
  for (std::size_t lane = 0; lane < kGroup; lane += kWidth) {
    constexpr auto solve = kBend ? solve_bending : solve_stretch;
    solve(step, group, lane, scratch.factor, scratch.moved);
    const double* corrected = scratch.moved;
    if constexpr (kCorrect)
      corrected = correct_lengths(step, group, lane, scratch.factor, scratch.moved, scratch.other);
    finish<kContact>(step, group, lane, corrected, scratch);
  }
}

template <bool kBend, bool kCorrect>
StepGroup chosen(bool contact) {
  return contact ? step_group<kBend, kCorrect, true> : step_group<kBend, kCorrect, false>;
}
template <bool kBend>
StepGroup chosen(bool correction, bool contact) {
  return correction ? chosen<kBend, true>(contact) : chosen<kBend, false>(contact);
}
StepGroup chosen_kernel(const Parts& parts) {
  return parts.bending ? chosen<true>(parts.correction, parts.contact)
                       : chosen<false>(parts.correction, parts.contact);
}

}  // namespace hair::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hair::engine {

HWY_EXPORT(chosen_kernel);

StepGroup step_group_for(const Parts& parts) {
  return HWY_DYNAMIC_DISPATCH(chosen_kernel)(parts);
}

}  // namespace hair::engine
#endif
