// run.json: what a run was, how it went, and what each of its frames measures.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hair/scene/playback.h"
#include "hair/scene/scene.h"

namespace hair {

enum class Ending { finished, interrupted, blow_up };

struct FrameRecord {
  double time = 0;  // s
  FrameMeasures measures;
  Work work;  // from the start to here
};

// What each stage took, s.
struct Seconds {
  double simulate = 0, measure = 0, write = 0;                      // states
  double upload = 0, shadow = 0, draw = 0, read_back = 0, png = 0;  // pictures
  double film = 0;
};

struct RunRecord {
  int frames_asked = 0;  // after the first
  Ending ending = Ending::finished;
  std::string blow_up;  // where it broke
  std::vector<int> strands;
  int particles = 0;
  std::vector<FrameRecord> frames;

  // Why there are none of them, or nothing.
  std::optional<std::string> no_pictures, no_film;
  std::string opengl;  // what drew them

  Seconds seconds;
};

// How every run.json begins: by this a run's folder is known.
inline constexpr std::string_view kRunRecordBegin = "{\n  \"program\": \"hairlab\"";

// A line for each frame. Everything but "seconds" is the same whenever the same is run again.
std::string run_json(const Scene& scene, const RunRecord& record);

}  // namespace hair
