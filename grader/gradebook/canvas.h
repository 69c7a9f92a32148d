// STAFF ONLY. Fills in Canvas's gradebook, in its own form.
#pragma once

#include "grader/gradebook/filling.h"

namespace grader::inline gradebook {

// The assignment's column is found by its number or title, and never made. Titles, the row of points and all
// cells that are no score of this column stay; "EX" and "N/A" do, too. Throws BadInput for a table that is no
// export of Canvas.
Gradebook fill_canvas(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options);

}  // namespace grader::gradebook
