// The lecture includes "linearSolver.h" without a folder, and so may a student's file.
#pragma once

#include "solver/linearSolver.h"
