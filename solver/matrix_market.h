// Matrices in files: the Matrix Market exchange format.
// Source: R. Boisvert, R. Pozo, K. Remington, "The Matrix Market Exchange Formats: Initial Design", NISTIR
// 5935 (1996).
//
// Read: `matrix coordinate real general|symmetric` and `matrix array real general|symmetric` (also `integer`,
// and `pattern`, read as ones, for coordinate). A symmetric file holds the lower triangle; entries for the
// same place add up. Written: `coordinate real general` for matrices and `array real general` for vectors,
// with 17 significant digits, so that reading them back gives the same bits. Numbers have a decimal point and
// no other mark, whatever the locale.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "solver/matrices.h"

namespace solver {

// Throws std::invalid_argument with one line, "name:line: what is wrong; what would be right", where `name`
// names the stream. Throws for entries that are not finite, and for more than 100 million entries, rows or
// columns.
SparseMatrix read_matrix_market(std::istream& in, const std::string& name);
SparseMatrix read_matrix_market(const std::string& path);

// Throws std::invalid_argument for an entry that is not finite, because the readers reject it.
void write_matrix_market(std::ostream& out, const SparseMatrix& matrix);

// A vector is a matrix of one column, written as an array.
std::vector<double> read_vector(std::istream& in, const std::string& name);
std::vector<double> read_vector(const std::string& path);
void write_vector(std::ostream& out, const std::vector<double>& values);

}  // namespace solver
