// STAFF ONLY. Plays a scene in which one exercise is a student's and all others are the reference's, while
// the student's process holds the student's object alone.
//
// Exercise libraries are interchangeable file by file. So for each exercise X there is a proxy, generated
// from exercise/X/calls.h, which defines X's functions: each asks the student's worker, by the request that
// the suite's cases send, too. A player, players/X.so, holds the code that plays scenes, the reference's
// other exercises and the proxy. It is ours, and the suite loads it: the suite itself links the reference's X
// for its checks.
//
// The proxies trust no answer: lengths are checked, counts are bounded, numbers may be anything.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grader/wire/message.h"
#include "grader/wire/products.h"
#include "hair/scene/scene.h"
#include "particles/state.h"

namespace grader::inline judge {

// Sends a request to the student's worker and returns the reply. Throws what ends the run.
using Ask = std::function<MessageReader(const MessageWriter& request, const Products& products)>;

// A scene that was played with a student's code. Its sizes are right; its numbers are untrusted and may be
// anything.
struct Played {
  std::vector<particles::State> frames;  // the first is the start; at most as many as the scene has
  std::string trouble;                   // empty, or the place of a blow-up
  std::vector<Eigen::VectorXd>
      dense;  // m, of each frame: see dense_strands.h; none for a scene without dense hair

  // Counts, as the student's code reports them.
  std::int64_t solver_steps = 0;      // of ConjGrad
  std::int64_t correction_steps = 0;  // of the length correction
};

enum class PlayEnd {
  finished,
  malformed,  // an answer of another form
  threw,      // the scene's code, at numbers that the student's code made
};

struct PlayResult {
  Played played;
  PlayEnd end = PlayEnd::finished;
  std::string note;  // for staff, unless it is finished
};

// The function of a player. Exceptions of `ask` go through it.
using PlayFunction = void (*)(const hair::Scene& scene, const Ask& ask, PlayResult& play);
inline constexpr const char* kPlayerName = "play";

}  // namespace grader::judge
