// STAFF ONLY. Answers questions about a force.
#include "grader/calls/force_server.h"

#include "grader/wire/force_answer.h"

namespace grader::inline calls {
namespace {

// A step needs no more; further evaluations of a student's code are counted, and not kept.
constexpr std::size_t kForcesKept = 4;

}  // namespace

bool ForceServer::operator()(int which, const std::vector<double>& question, std::vector<double>& answer) {
  if (which < kForceEnergy || which > kForceBand) throw MalformedMessage("an operator that is not there");
  if (static_cast<int>(question.size()) != size_of_question(which, size_))
    throw MalformedMessage("a question that makes no sense");

  answer_about(force_, which, size_, question, answer);
  if (which == kForceForce && forces_at.size() < kForcesKept) {
    forces_at.push_back({Eigen::Map<const Eigen::VectorXd>(question.data(), size_),
                         Eigen::Map<const Eigen::VectorXd>(question.data() + size_, size_)});
    products_before.push_back(dfdv);
  }
  int* const counts[] = {&energies, &forces, &dfdx, &dfdv, &bands};
  ++*counts[which - kForceEnergy];
  return energies + forces + dfdx + dfdv + bands <= most_;
}

}  // namespace grader::calls
