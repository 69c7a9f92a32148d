// Published numbers of heads with many strands, on other machines and of other scenes.
#pragma once

#include "hair/io/plot/page.h"

namespace hair::head_study {

Table published_heads();

}  // namespace hair::head_study
