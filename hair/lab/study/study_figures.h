// A study's figures: an error, for all methods, against the cost or against the step.
#pragma once

#include "hair/io/plot/figure.h"
#include "hair/lab/study/study.h"

namespace hair {

enum class Against { time, step, work };

// A run that did not finish is drawn at the upper edge, at the cost of a whole run. An error below the
// reference's accuracy is drawn on the line that marks that accuracy.
Figure error_figure(const Study& study, Norm norm, Against against);

}  // namespace hair
