#include "solver/matrix_market.h"
