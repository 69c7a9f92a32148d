// STAFF ONLY. Answers questions about a force.
#include "grader/calls/object_servers.h"

#include "solver/block_band.h"

namespace grader::inline calls {
namespace {

// A step needs no more; further evaluations of a student's code are counted, and not kept.
constexpr std::size_t kForcesKept = 4;

// Returns the length of a question, with vectors of `size` numbers.
int size_of_question(int which, int size) {
  switch (which) {
    case kForceEnergy:
      return size;
    case kForceForce:
      return 3 * size;
    case kForceBand:
      return 2 * size + 2;
    default:
      return 4 * size;
  }
}

// `question` has size_of_question(which, size) numbers.
void answer_about(const particles::Force& force, int which, int size, const std::vector<double>& question,
                  std::vector<double>& answer) {
  const auto vector = [&](int i) {
    return Eigen::Map<const Eigen::VectorXd>(question.data() + static_cast<std::ptrdiff_t>(i) * size, size);
  };
  if (which == kForceEnergy) {
    answer.assign(1, force.energy(vector(0)));
    return;
  }
  if (which == kForceBand) {
    answer.assign(size_of_band(size), 0.0);
    solver::BlockBand band(Eigen::Map<Eigen::MatrixXd>(answer.data() + 1, size, solver::BlockBand::kColumns));
    Eigen::MatrixXd work(size, particles::kBandScratch);
    const double* factors = question.data() + 2 * static_cast<std::ptrdiff_t>(size);
    answer[0] = force.add_band(vector(0), vector(1), factors[0], factors[1], band, work);
    return;
  }
  answer.assign(question.end() - size, question.end());
  Eigen::Map<Eigen::VectorXd> sum(answer.data(), size);
  if (which == kForceForce)
    force.add_force(vector(0), vector(1), sum);
  else if (which == kForceDfdx)
    force.add_dfdx(vector(0), vector(1), vector(2), sum);
  else
    force.add_dfdv(vector(0), vector(1), vector(2), sum);
}

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
