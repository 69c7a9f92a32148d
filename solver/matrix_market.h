// The files of the checks' golden data: a matrix by its entries, and a vector, in the Matrix Market format
// (R. Boisvert, R. Pozo, K. Remington, NISTIR 5935, 1996), `coordinate real general` and `array real
// general`. Numbers have 17 significant digits, so that reading them back gives the same bits, and a decimal
// point, whatever the locale.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "solver/matrices.h"

namespace solver {

// Throws std::invalid_argument for a file that is not as one of the writers wrote it.
SparseMatrix read_matrix_market(const std::string& path);
std::vector<double> read_vector(const std::string& path);

void write_matrix_market(std::ostream& out, const SparseMatrix& matrix);
void write_vector(std::ostream& out, const std::vector<double>& values);

}  // namespace solver
