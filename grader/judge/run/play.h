// STAFF ONLY. Runs a scene with one exercise of a student and all others of the reference. The student's
// process holds the student's object alone.
//
// Exercise libraries are interchangeable file by file. So for each exercise X there is a proxy, generated
// from exercise/X/calls.h, which defines X's functions: each sends the student's worker the same requests as
// the suite's cases. A runner, runners/X.so, holds the code that runs scenes, the reference's other exercises
// and the proxy. The suite loads this trusted library, since it links the reference's X itself for its
// checks.
//
// The proxies trust no answer: lengths are checked, counts are bounded, numbers may be anything.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grader/wire/message.h"
#include "hair/scene/scene.h"
#include "particles/state.h"

namespace grader::inline judge {

// Sends a request to the student's worker and returns the reply. Its exceptions end the run.
using Ask = std::function<MessageReader(const MessageWriter& request, const Products& products)>;

// The way of proxies to the student's worker of the present run.
MessageReader ask_student(const MessageWriter& request, const Products& products);
MessageReader ask_student(const MessageWriter& request);  // for functions that call nothing back

// Holds a run of a scene with a student's code. Its sizes are right; its numbers are untrusted and may be
// anything.
struct Played {
  std::vector<particles::State> frames;         // the first is the start; at most as many as the scene has
  std::string trouble;                          // empty, or the place of a blow-up
  std::vector<std::uint32_t> coordinates = {};  // the kind of each body's, in a run of this process
  std::vector<Eigen::VectorXd>
      dense;  // m, of each frame: see play_scene.h; empty for a scene without dense hair

  // Counts, as the student's code reports them.
  std::int64_t solver_steps = 0;      // ConjGrad's
  std::int64_t correction_steps = 0;  // the length correction's
};

enum class PlayEnd {
  finished,
  malformed,  // an answer in another format
  threw,      // the scene's code threw, because of the student's numbers
};

struct PlayResult {
  Played played;
  PlayEnd end = PlayEnd::finished;
  std::string note;  // for staff, unless the run is finished
};

// Declares the function of a runner. Exceptions of `ask` go through it.
using PlayFunction = void (*)(const hair::Scene& scene, const Ask& ask, PlayResult& play);
inline constexpr const char* kRunnerName = "play";

}  // namespace grader::judge
