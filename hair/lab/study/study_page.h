// A study as an HTML page: the cheapest method for each error, the observed orders, and the failures.
#pragma once

#include "hair/io/plot/page.h"
#include "hair/lab/study/study.h"

namespace hair {

Page study_page(const Study& study);

}  // namespace hair
