// STAFF ONLY. The one function that a player exports.
#include <exception>

#include "grader/play/asking.h"
#include "grader/play/play.h"
#include "hair/scene/playback.h"

namespace grader {
namespace {

// What a run may ask about our matrices, forces and accelerations: 24 times what a good S1 asks, and more than
// ten times what a good H4 does. A solver that goes nowhere is wrong, and is not played until its limits of time.
constexpr int kMostQuestions = 400'000;

// Contracts have no argument for who is asked. A player plays one scene at a time.
const Ask* asked = nullptr;
int questions = 0;

class Asked {
 public:
  explicit Asked(const Ask& ask) {
    asked = &ask;
    questions = 0;
  }
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked() { asked = nullptr; }
};

// Until it ends or breaks.
void play_frames(const hair::Scene& scene, Played& played) {
  hair::Scene unwatched = scene;  // nobody has to have written energies
  unwatched.hair.watched = false;
  hair::Playback playback(unwatched);
  played.frames.push_back(playback.state());
  for (int k = 0; k < scene.frames && played.trouble.empty(); ++k) {
    played.trouble = playback.advance().value_or("");
    if (played.trouble.empty()) played.frames.push_back(playback.state());
  }
  const hair::Work work = playback.work();
  played.solver_steps = work.solver_steps;
  played.correction_steps = work.correction_steps;
}

}  // namespace

MessageReader ask_student(const MessageWriter& request, const Products& products) {
  return (*asked)(request, [&](int which, const std::vector<double>& x, std::vector<double>& y) {
    return products(which, x, y) && ++questions <= kMostQuestions;
  });
}

MessageReader ask_student(const MessageWriter& request) {
  return ask_student(request, [](int, const auto&, auto&) -> bool {
    throw MalformedMessage("a product that nobody asked for");
  });
}

}  // namespace grader

extern "C" __attribute__((visibility("default"))) void play(const hair::Scene& scene, const grader::Ask& ask,
                                                            grader::PlayResult& result) {
  const grader::Asked asked(ask);
  try {
    grader::play_frames(scene, result.played);
  } catch (const grader::MalformedMessage& error) {
    result.end = grader::PlayEnd::malformed;
    result.note = error.what();
  } catch (const std::exception& error) {
    result.end = grader::PlayEnd::threw;
    result.note = error.what();
  }
}
