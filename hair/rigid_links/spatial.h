// The spatial vectors of H7, by the name that older files include.
#pragma once

#include "hair/spatial.h"
