// A link of H7, by the name that older files include.
#pragma once

#include "hair/link.h"
