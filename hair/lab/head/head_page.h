// The study of a head as a page: error against run time for each hair, pictures, and what others report.
#pragma once

#include <string>

#include "hair/io/plot/page.h"
#include "hair/lab/head/head_study.h"

namespace hair::head_study {

Page head_page(const HeadStudy& study, const std::string& machine);

}  // namespace hair::head_study
