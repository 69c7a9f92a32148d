// STAFF ONLY. Defines the one function that a runner exports.
#include <exception>

#include "grader/judge/run/play.h"
#include "grader/judge/run/play_scene.h"

namespace grader::inline judge {
namespace {

// Bounds the questions of a run about our matrices, forces and accelerations: a good S1 asks 24 times less,
// and a good H4 more than ten times less. A solver that does not converge is wrong, so its run ends here,
// before the limits of time.
constexpr int kMostQuestions = 400'000;

// The exercises' functions have no argument for `Ask`. A runner runs one scene at a time.
const Ask* asked = nullptr;
int questions = 0;

class Questions {
 public:
  explicit Questions(const Ask& ask) {
    asked = &ask;
    questions = 0;
  }
  Questions(const Questions&) = delete;
  Questions& operator=(const Questions&) = delete;
  ~Questions() { asked = nullptr; }
};

}  // namespace

MessageReader ask_student(const MessageWriter& request, const Products& products) {
  return (*asked)(request, [&](int which, const std::vector<double>& x, std::vector<double>& y) {
    return products(which, x, y) && ++questions <= kMostQuestions;
  });
}

MessageReader ask_student(const MessageWriter& request) {
  return ask_student(request, [](int, const auto&, auto&) -> bool {
    throw MalformedMessage("a product, but no solver runs");
  });
}

}  // namespace grader::judge

extern "C" __attribute__((visibility("default"))) void play(const hair::Scene& scene, const grader::Ask& ask,
                                                            grader::PlayResult& result) {
  const grader::Questions asked(ask);
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
