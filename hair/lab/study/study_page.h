// A study as a page for people: which method is the cheapest at which error, which orders it shows, what
// failed.
#pragma once

#include "hair/io/plot/page.h"
#include "hair/lab/study/study.h"

namespace hair {

Page study_page(const Study& study);

}  // namespace hair
