// The strand of H8, by the name that older files include.
#pragma once

#include "hair/helix.h"
