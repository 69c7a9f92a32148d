// STAFF ONLY.
#include "grader/exercise/force_server.h"

#include "grader/wire/force_answer.h"

namespace grader {
namespace {

// No step takes more; what a student's code asks for beyond them is counted, and not kept.
constexpr std::size_t kForcesKept = 4;

}  // namespace

bool ForceServer::operator()(int which, const std::vector<double>& question, std::vector<double>& answer) {
  if (which < kForceEnergy || which > kForceBand) throw MalformedMessage("an operator that is not there");
  if (static_cast<int>(question.size()) != size_of_question(which, size_))
    throw MalformedMessage("a question that makes no sense");

  answer_about(force_, which, size_, question, answer);
  if (which == kForceForce && forces_at.size() < kForcesKept)
    forces_at.emplace_back(question.begin(), question.begin() + size_);
  int* const counts[] = {&energies, &forces, &dfdx, &dfdv, &bands};
  ++*counts[which - kForceEnergy];
  return energies + forces + dfdx + dfdv + bands <= most_;
}

}  // namespace grader
