// run.json: the settings and the outcome of a run, and the measures of each frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hair/lab/run/states_file.h"
#include "hair/scene/scene.h"
#include "hair/scene/scene_run.h"

namespace hair {

enum class Ending { finished, interrupted, blow_up };
const char* name_of(Ending ending);  // "finished", "interrupted", "blow-up"

struct FrameRecord {
  double time = 0;  // s
  FrameMeasures measures;
  Work work;  // from the start to this frame
};

// The duration of each stage, s. Together they are `total`.
struct Seconds {
  double read = 0, assemble = 0, prepare = 0;   // the scene; the moving objects; the drawing
  double simulate = 0, measure = 0, write = 0;  // states
  double lay_out = 0;                           // the content of a picture: dense hair, out of obstacles
  double draw = 0, png = 0, film = 0;
  double total = 0;
};

struct RunRecord {
  int frames_asked = 0;  // after the first
  Ending ending = Ending::finished;
  std::string blow_up;  // the place of the blow-up
  std::vector<int> strands;
  int particles = 0;
  std::vector<FrameRecord> frames;
  std::vector<Warning> warnings;
  std::optional<LinksFile> links;  // none without a control mesh
  double worn_off = 0;             // J: see MeshRecord
  std::optional<double> off_by;    // about how far places are off, of a strand's length; none: unknown

  // The reason why there are none, or nothing.
  std::optional<std::string> no_pictures, no_film;
  std::string opengl;                    // the renderer's name
  std::optional<SynthesisCounts> dense;  // for the last picture's dense hair; none without any
  long moved_out = 0;                    // the number of these strands that were moved out of obstacles
  std::size_t guides_left_out = 0;       // guides that were not simulated, since no picture shows them

  Seconds seconds;
};

// The beginning of every run.json: it identifies the folder of a run.
inline constexpr std::string_view kRunRecordBegin = "{\n  \"program\": \"hairlab\"";

// One line: "strand 3 gains energy ..., from step 17 on; ...". Empty without warnings.
std::string warning_text(const std::vector<Warning>& warnings);

// One line for each frame. Equal runs give equal text, except for "seconds".
std::string run_json(const Scene& scene, const RunRecord& record);

}  // namespace hair
