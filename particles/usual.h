// The headers that nearly every exercise with Eigen includes. At home and in grading they are precompiled for
// all of these exercises; a file that includes them itself costs nothing more.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "particles/vectors.h"
