// Every strand of a head, or some of them with the others made by synthesis (H10): the error of that, and the
// run time of both. As plain data.
//
// All sets of guides move beside the whole head, frame by frame, so that no motion is kept. Times are CPU
// times of all threads, s, for the second in which the head moves. Finding a strand's guides is not in them:
// it is done once.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hair/head/synthesis.h"
#include "hair/lab/head/head_errors.h"
#include "hair/lab/head/moving_head.h"

namespace hair::head_study {

struct ModeName {
  SynthesisMode mode;
  const char* id;  // "interpolate": in files
};
inline constexpr std::array<ModeName, 3> kModes = {{{SynthesisMode::interpolate, "interpolate"},
                                                    {SynthesisMode::extrapolate, "extrapolate"},
                                                    {SynthesisMode::blend, "blend"}}};

struct ModeRun {
  HeadErrors errors;
  double synthesis = 0;  // s, for all frames
};

struct GuideRun {
  int guides = 0;
  double simulation = 0;  // s, of the guides
  std::array<ModeRun, kModes.size()> modes;

  double seconds(std::size_t mode) const { return simulation + modes[mode].synthesis; }
};

struct HeadCase {
  const HeadHair* hair = nullptr;
  bool collides = false;
  bool fast = false;  // by the engine, else by the exercises
  int strands = 0;
  double length = 0;   // m, of a strand, in the mean
  double seconds = 0;  // of every strand simulated
  std::vector<GuideRun> runs;
};

// A picture of hair that was interpolated, or of all strands simulated.
struct HeadPicture {
  std::string hair, file;  // the hair's id; "straight-few.png"
  int guides = 0;          // as many as strands: each is simulated
};

struct HeadStudy {
  int threads = 1;
  std::vector<HeadCase> cases;
  std::vector<HeadPicture> pictures;
  std::string no_pictures;  // why there are none; empty: there are
};

struct HeadStudySettings {
  bool collides = true;
  int threads = 1;
  std::vector<int> guides;  // those that are more than strands are left out
};

// In the middle of the way back.
inline constexpr int kPictured = kSettle + 22;

// What is called there: interpolated from so many guides, or all strands simulated, if these are as many. 3
// numbers a point.
using SeeHead = std::function<void(int guides, std::span<const double> points)>;

// Empty if interrupted. `say` is told what is being done; `see` may be empty.
std::optional<HeadCase> study_head(const std::shared_ptr<const Bust>& bust, const GrownHead& head,
                                   const HeadStudySettings& settings, const std::atomic<bool>& interrupted,
                                   const std::function<void(const std::string&)>& say, const SeeHead& see);

}  // namespace hair::head_study
