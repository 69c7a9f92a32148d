#include "hair/lab/study/written_down.h"

namespace hair {

std::optional<WrittenRun> run_written_down(const Problem&, const StudyMethod&, int) {
  return {};
}

}  // namespace hair
