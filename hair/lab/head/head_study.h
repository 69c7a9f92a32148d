// Every strand of a head simulated, or some of them with the others made by synthesis (H10): the error of
// synthesis, and the run time of both. As plain data.
//
// All sets of guides move together with the whole head, frame by frame, so that no motion is stored. Times
// are CPU times, s, for the second in which the head moves. They exclude the search for a
// strand's guides, which is done once.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hair/dense/synthesis.h"
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
  int strands = 0;
  double length = 0;   // m, the mean of all strands
  double seconds = 0;  // for every strand simulated
  std::vector<GuideRun> runs;
};

// A picture of hair that was interpolated, or of all strands simulated.
struct HeadPicture {
  std::string hair, file;  // the hair's id; "straight-few.png"
  int guides = 0;          // equals the number of strands if each is simulated
};

struct HeadStudy {
  std::vector<HeadCase> cases;
  std::vector<HeadPicture> pictures;
  std::string no_pictures;  // the reason why there are none; empty: there are pictures
};

struct HeadStudySettings {
  bool collides = true;
  std::vector<int> guides;  // sets with more guides than strands are left out
};

// In the middle of the way back.
inline constexpr int kPictured = kSettle + 22;

// Gets the points at kPictured: interpolated from so many guides, or all strands simulated, if their number
// is as large. 3 numbers a point.
using SeeHead = std::function<void(int guides, std::span<const double> points)>;

// Empty if interrupted. Calls `say` with the present task; `see` may be empty.
std::optional<HeadCase> study_head(const std::shared_ptr<const Bust>& bust, const GrownHead& head,
                                   const HeadStudySettings& settings, const std::atomic<bool>& interrupted,
                                   const std::function<void(const std::string&)>& say, const SeeHead& see);

}  // namespace hair::head_study
