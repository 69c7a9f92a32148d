// STAFF ONLY. Tests the scenes of a study with the reference.
#include "grader/judge/study/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "hair/scene/playback.h"

namespace grader::inline judge {
namespace {

struct Frame {
  double time;
  particles::State state;
  hair::FrameMeasures measures;
};

std::vector<Frame> play(const SceneText& text) {
  const hair::Scene scene = hair::parse_scene(text.json, text.name);
  hair::Playback playback(scene);
  std::vector<Frame> frames{{0, playback.state(), playback.measure(playback.state())}};
  for (int k = 0; k < scene.frames; ++k) {
    const auto trouble = playback.advance();
    EXPECT_FALSE(trouble) << text.name << ": " << *trouble;
    frames.push_back({playback.time(), playback.state(), playback.measure(playback.state())});
  }
  return frames;
}

const SceneText& scene_of(const std::string& name) {
  for (const SceneText& text : studied_scenes())
    if (text.name == name) return text;
  throw std::invalid_argument(name);
}

TEST(StudiedScenes, EachEndsSoundWithItsFrames) {
  for (const SceneText& text : studied_scenes()) {
    const std::vector<Frame> frames = play(text);
    ASSERT_GE(frames.size(), 10U) << text.name;
    const Eigen::Index size = frames.front().state.x.size();
    double last = -1;
    for (const Frame& frame : frames) {
      EXPECT_EQ(frame.state.x.size(), size) << text.name;
      EXPECT_EQ(frame.state.v.size(), size) << text.name;
      EXPECT_TRUE(frame.state.x.allFinite() && frame.state.v.allFinite()) << text.name;
      EXPECT_TRUE(std::isfinite(frame.measures.stretch) && std::isfinite(frame.measures.energy()))
          << text.name;
      EXPECT_GT(frame.time, last) << text.name;
      last = frame.time;
    }
    // Something must move by at least a tenth of a millimetre.
    EXPECT_GT((frames.back().state.x - frames.front().state.x).norm(), 1e-4) << text.name;
  }
}

TEST(StudiedScenes, TwiceTheSameBits) {
  for (const SceneText& text : studied_scenes()) {
    const std::vector<Frame> one = play(text), two = play(text);
    for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].state.x, two[k].state.x);
  }
}

TEST(StudiedScenes, TogetherNeedAllExercisesThatScenesCall) {
  std::set<std::string> all;
  for (const SceneText& text : studied_scenes())
    for (const std::string& id : exercises_of(hair::parse_scene(text.json, text.name))) all.insert(id);
  EXPECT_EQ(all, (std::set<std::string>{"S1", "P1", "P2", "H1", "H2", "H3", "H4", "H5", "H6"}));
}

TEST(StudiedScenes, StretchIsWhatTheMethodPromises) {
  for (const Frame& frame : play(scene_of("strand-swing"))) EXPECT_LE(frame.measures.stretch, 1e-10);
  for (const Frame& frame : play(scene_of("bead-on-wire"))) EXPECT_LE(frame.measures.stretch, 1e-3);
}

}  // namespace
}  // namespace grader::judge
