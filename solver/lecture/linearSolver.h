// The lecture includes "linearSolver.h", without a folder. So may a student's file.
#pragma once

#include "solver/linearSolver.h"
