// What others report of heads with many strands: their numbers, on their machines, of their scenes.
#pragma once

#include "hair/io/plot/page.h"

namespace hair::head_study {

Table published_heads();

}  // namespace hair::head_study
