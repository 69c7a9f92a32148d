#include <stdexcept>

#include "hair/truth/cvode.h"

namespace hair {

std::optional<CvodeRun> run_cvode(Ode&, double, int, const CvodeWay&, const std::atomic<bool>&) {
  throw std::invalid_argument(
      "built without SUNDIALS, whose CVODE says how things really move; install libsundials-dev (macOS: brew "
      "install sundials) and build again");
}

bool have_cvode() {
  return false;
}

std::string cvode_version() {
  return "";
}

}  // namespace hair
