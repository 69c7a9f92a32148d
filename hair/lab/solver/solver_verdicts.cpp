#include "hair/lab/solver/solver_record.h"

#include <algorithm>

namespace hair::solver_lab {

namespace {

using namespace solver::study;

constexpr double kAboveRounding = 1e-9;  // larger errors contain no rounding
constexpr double kGood = 1e-10;

// "a, b and c"
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

// The first progress with an error below kGood; null if there is none.
const Progress* good(const History& history) {
  const auto found =
      std::ranges::find_if(history.progress, [](const Progress& one) { return one.error <= kGood; });
  return found == history.progress.end() ? nullptr : &*found;
}

std::string time_of(const History& history) {
  const Progress* there = good(history);
  return history.solver + (there ? " " + to_text(1e6 * there->seconds) + " \u00B5s" : " does not get there");
}

}  // namespace

std::string step_of(const std::string& system) {
  const std::size_t at = system.find("h = ");
  return at == std::string::npos ? system : system.substr(at);
}

std::string bound_verdict(const std::vector<Compared>& systems) {
  std::vector<std::string> above;
  for (const Compared& on : systems) {
    const History& history = on.conj_grad;
    // NaN counts as above, too.
    const auto points = std::ranges::count_if(history.progress, [&](const Progress& one) {
      return !(one.error <= std::max(kAboveRounding, error_bound(history.condition, one.iterations)));
    });
    if (points > 0)
      above.push_back(history.system + " (" + std::to_string(points) + " of " +
                      std::to_string(history.progress.size()) + " points)");
  }
  return above.empty()
             ? "ConjGrad's errors are all below the bound."
             : "ConjGrad's errors are above the bound, where theory has none: " + listed(above) + ".";
}

std::string time_verdict(const std::vector<Compared>& systems) {
  std::string text;
  for (const Compared* on : {&systems.front(), &systems.back()}) {
    text += (text.empty() ? "To an error of " + to_text(kGood) + ", with " : "; with ") +
            step_of(on->conj_grad.system) + ": " + time_of(on->conj_grad) + ", " + time_of(on->eigen);
    if (on->direct)
      text += ", " + on->direct->solver + " " +
              to_text(1e6 * (on->direct->factor_seconds + on->direct->solve_seconds)) + " \u00B5s";
  }
  return text + ".";
}

std::string needed_verdict(const std::vector<IterationsNeeded>& needed) {
  std::vector<std::string> above;
  for (const IterationsNeeded& one : needed)
    if (!one.conj_grad || *one.conj_grad > one.bound) above.push_back(to_text(one.condition));
  std::string text = above.empty() ? "ConjGrad takes no more than that anywhere."
                                   : "ConjGrad takes more than that, or nothing that is true, at condition "
                                     "numbers of " +
                                         listed(above) + ".";
  const auto both = std::find_if(needed.rbegin(), needed.rend(),
                                 [](const IterationsNeeded& one) { return one.conj_grad && one.eigen; });
  if (both != needed.rend())
    text += " At " + to_text(both->condition) + " it takes " + std::to_string(*both->conj_grad) +
            " iterations, Eigen's " + std::to_string(*both->eigen) + ".";
  return text;
}

std::string stopped_verdict(const std::vector<DigitsLost>& digits) {
  std::vector<std::string> stopped;
  int most = 0;
  for (const DigitsLost& one : digits)
    if (one.stopped) {
      stopped.push_back(to_text(one.condition));
      most = one.iterations;
    }
  if (stopped.empty()) return "";
  return "ConjGrad on A'A was stopped after the " + std::to_string(most) +
         " iterations that it may take here, before rounding ended it, at condition numbers of " +
         listed(stopped) + ": these points stand at the figure's upper edge.";
}

}  // namespace hair::solver_lab
