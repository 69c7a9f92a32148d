// STAFF ONLY. The one function that a player exports.
#include <exception>

#include "grader/judge/run/asking.h"
#include "grader/judge/run/play.h"
#include "grader/judge/run/play_scene.h"

namespace grader::inline judge {
namespace {

// What a run may ask about our matrices, forces and accelerations: 24 times what a good S1 asks, and more
// than ten times what a good H4 does. A solver that goes nowhere is wrong, and is not played until its limits
// of time.
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

}  // namespace grader::judge

extern "C" __attribute__((visibility("default"))) void play(const hair::Scene& scene, const grader::Ask& ask,
                                                            grader::PlayResult& result) {
  const grader::Asked asked(ask);
  try {
    grader::play_scene(scene, result.played);
  } catch (const grader::MalformedMessage& error) {
    result.end = grader::PlayEnd::malformed;
    result.note = error.what();
  } catch (const std::exception& error) {
    result.end = grader::PlayEnd::threw;
    result.note = error.what();
  }
}
