// STAFF ONLY. Guides in a message, for H10: root frames, guides, and what is carried along them.
#pragma once

#include "grader/wire/message.h"
#include "hair/strand_synthesis.h"

namespace grader {

// A guide that owns its points.
struct OwnGuide {
  hair::RootFrame root;
  Eigen::VectorXd points;

  hair::GuideHair view() const { return {root, {points.data(), points.size()}}; }
};

void put(MessageWriter& message, const hair::RootFrame& frame);
void put(MessageWriter& message, const OwnGuide& guide);
void put(MessageWriter& message, const hair::GuideFrames& frames);

// Each throws MalformedMessage for a message that is too short. Numbers may be anything.
hair::RootFrame get_root_frame(MessageReader& message);
OwnGuide get_guide(MessageReader& message);  // also for fewer than two points
hair::GuideFrames get_guide_frames(MessageReader& message,
                                   std::size_t points);  // also for another number of points

}  // namespace grader
