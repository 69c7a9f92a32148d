// STAFF ONLY.
#include "grader/play/force_server.h"

namespace grader {
namespace {

// No step takes more; what a student's code asks for beyond them is counted, and not kept.
constexpr std::size_t kForcesKept = 4;

}  // namespace

bool ForceServer::operator()(int which, const std::vector<double>& question, std::vector<double>& answer) {
  if (which < kForceEnergy || which > kForceDfdv) throw MalformedMessage("an operator that is not there");
  if (static_cast<int>(question.size()) != vectors_of_question(which) * size_)
    throw MalformedMessage("a question that makes no sense");

  const auto vector = [&](int i) {
    return Eigen::Map<const Eigen::VectorXd>(question.data() + static_cast<std::ptrdiff_t>(i) * size_, size_);
  };
  if (which == kForceEnergy)
    answer.assign(1, 0.0);
  else
    answer.assign(question.end() - size_, question.end());
  Eigen::Map<Eigen::VectorXd> result(answer.data(), static_cast<Eigen::Index>(answer.size()));
  switch (which) {
    case kForceEnergy:
      ++energies;
      result[0] = force_.energy(vector(0));
      break;
    case kForceForce:
      ++forces;
      if (forces_at.size() < kForcesKept) forces_at.emplace_back(question.begin(), question.begin() + size_);
      force_.add_force(vector(0), vector(1), result);
      break;
    case kForceDfdx:
      ++dfdx;
      force_.add_dfdx(vector(0), vector(1), vector(2), result);
      break;
    default:
      ++dfdv;
      force_.add_dfdv(vector(0), vector(1), vector(2), result);
  }
  return energies + forces + dfdx + dfdv <= most_;
}

}  // namespace grader
