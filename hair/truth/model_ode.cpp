#include "hair/truth/model_ode.h"

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include "solver/course.h"

namespace hair {

namespace {

struct OdeRow {
  const char* model;  // ModelRow::id
  std::unique_ptr<Ode> (*make)(const Problem& problem);
};

// With what the course has; a row that is not used is not linked.
template <bool has_links>
constexpr auto rows() {
  if constexpr (has_links)
    return std::array{OdeRow{"rigid_links", links_ode}};
  else
    return std::array<OdeRow, 0>{};
}
constexpr auto kRows = rows<in_course("H7")>();

const OdeRow* row_of(const ModelRow& model) {
  for (const OdeRow& row : kRows)
    if (std::string_view(row.model) == model.id) return &row;
  return nullptr;
}

}  // namespace

bool has_ode(const ModelRow& model) {
  return row_of(model) != nullptr;
}

std::unique_ptr<Ode> model_ode(const Problem& problem) {
  const ModelRow& model = *problem.scene.hair.modelled.at(0).model;
  const OdeRow* row = row_of(model);
  if (!row) throw std::invalid_argument(std::string("studies know no ") + model.id);
  return row->make(problem);
}

}  // namespace hair
