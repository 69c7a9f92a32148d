// A study's figures: an error, of all methods, against what it takes or against the step.
#pragma once

#include "hair/io/plot/figure.h"
#include "hair/lab/study/study.h"

namespace hair {

enum class Against { time, step, work };

// A run that did not get to its end stands at the upper edge, where the whole run would have been; an error
// that is below what the reference knows, on the line that says so.
Figure error_figure(const Study& study, Norm norm, Against against);

}  // namespace hair
