#include "solver/matrices.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

namespace solver {

SparseMatrix::SparseMatrix(int rows, int cols, const std::vector<Entry>& entries) : cols_(cols) {
  if (rows < 0 || cols < 0)
    throw std::invalid_argument("SparseMatrix: " + std::to_string(rows) + " x " + std::to_string(cols) +
                                " is no size; both must be >= 0");
  for (const Entry& e : entries)
    if (e.row < 0 || e.row >= rows || e.col < 0 || e.col >= cols)
      throw std::invalid_argument("SparseMatrix: entry (" + std::to_string(e.row) + ", " +
                                  std::to_string(e.col) + ") lies outside of a " + std::to_string(rows) +
                                  " x " + std::to_string(cols) + " matrix");
  std::vector<Entry> sorted = entries;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) {
    return a.row != b.row ? a.row < b.row : a.col < b.col;
  });
  row_begin_.assign(static_cast<std::size_t>(rows) + 1, 0);
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const Entry& e = sorted[k];
    if (k > 0 && sorted[k - 1].row == e.row && sorted[k - 1].col == e.col) {
      values_.back() += e.value;
      continue;
    }
    columns_.push_back(e.col);
    values_.push_back(e.value);
    ++row_begin_[e.row + 1];
  }
  for (int i = 0; i < rows; ++i) row_begin_[i + 1] += row_begin_[i];
}

void SparseMatrix::matVecMult(double x[], double b[]) {
  for (int i = 0; i < rows(); ++i) {
    double sum = 0;
    for (int k = row_begin_[i]; k < row_begin_[i + 1]; ++k) sum += values_[k] * x[columns_[k]];
    b[i] = sum;
  }
}

std::vector<SparseMatrix::Entry> SparseMatrix::entries() const {
  std::vector<Entry> result;
  result.reserve(values_.size());
  for (int i = 0; i < rows(); ++i)
    for (int k = row_begin_[i]; k < row_begin_[i + 1]; ++k) result.push_back({i, columns_[k], values_[k]});
  return result;
}

SparseMatrix SparseMatrix::transposed() const {
  std::vector<Entry> flipped = entries();
  for (Entry& e : flipped) std::swap(e.row, e.col);
  return SparseMatrix(cols_, rows(), flipped);
}

double SparseMatrix::norm_bound() const {
  std::vector<double> column_sums(cols_, 0.0);
  double largest_row_sum = 0;
  for (int i = 0; i < rows(); ++i) {
    double row_sum = 0;
    for (int k = row_begin_[i]; k < row_begin_[i + 1]; ++k) {
      row_sum += std::abs(values_[k]);
      column_sums[columns_[k]] += std::abs(values_[k]);
    }
    largest_row_sum = std::max(largest_row_sum, row_sum);
  }
  const double largest_column_sum =
      column_sums.empty() ? 0 : *std::max_element(column_sums.begin(), column_sums.end());
  return std::sqrt(largest_row_sum) * std::sqrt(largest_column_sum);
}

int SparseMatrix::longest_row() const {
  int longest = 0;
  for (int i = 0; i < rows(); ++i) longest = std::max(longest, row_begin_[i + 1] - row_begin_[i]);
  return longest;
}

SparseMatrix diagonal(const std::vector<double>& d) {
  const int n = static_cast<int>(d.size());
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < n; ++i) entries.push_back({i, i, d[i]});
  return SparseMatrix(n, n, entries);
}

SparseMatrix tridiagonal(int n, double main, double off) {
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < n; ++i) {
    if (i > 0) entries.push_back({i, i - 1, off});
    entries.push_back({i, i, main});
    if (i + 1 < n) entries.push_back({i, i + 1, off});
  }
  return SparseMatrix(n, n, entries);
}

SparseMatrix poisson_2d(int n) {
  if (n < 0 || n > 46340)  // 46341^2 is more than an int holds
    throw std::invalid_argument("poisson_2d: a grid of n = " + std::to_string(n) + "; need 0 <= n <= 46340");
  std::vector<SparseMatrix::Entry> entries;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int k = j * n + i;
      entries.push_back({k, k, 4});
      if (i > 0) entries.push_back({k, k - 1, -1});
      if (i + 1 < n) entries.push_back({k, k + 1, -1});
      if (j > 0) entries.push_back({k, k - n, -1});
      if (j + 1 < n) entries.push_back({k, k + n, -1});
    }
  return SparseMatrix(n * n, n * n, entries);
}

SparseMatrix hilbert(int n) {
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) entries.push_back({i, j, 1.0 / (i + j + 1)});
  return SparseMatrix(n, n, entries);
}

SparseMatrix strand_implicit_euler(const std::vector<double>& masses, double k, double k_bend, double h) {
  const int particles = static_cast<int>(masses.size());
  const double stiffness[3] = {k_bend, k_bend, k};
  std::vector<SparseMatrix::Entry> entries;
  for (int p = 0; p < particles; ++p)
    for (int c = 0; c < 3; ++c) {
      const int i = 3 * p + c;
      const double spring = h * h * stiffness[c];
      entries.push_back({i, i, masses[p] + spring});  // its own mass and the spring that it hangs from
      if (p == 0) continue;
      entries.push_back({i - 3, i - 3, spring});
      entries.push_back({i, i - 3, -spring});
      entries.push_back({i - 3, i, -spring});
    }
  return SparseMatrix(3 * particles, 3 * particles, entries);
}

SpectralMatrix::SpectralMatrix(std::vector<double> spectrum, std::vector<std::vector<double>> reflectors)
    : spectrum_(std::move(spectrum)), reflectors_(std::move(reflectors)) {
  for (std::vector<double>& v : reflectors_) {
    if (v.size() != spectrum_.size())
      throw std::invalid_argument("SpectralMatrix: a reflector of " + std::to_string(v.size()) +
                                  " values; the spectrum has " + std::to_string(spectrum_.size()));
    double squared = 0;
    for (double value : v) squared += value * value;
    if (!(squared > 0))
      throw std::invalid_argument("SpectralMatrix: a reflector is zero; it must have a direction");
    for (double& value : v) value /= std::sqrt(squared);
  }
}

void SpectralMatrix::matVecMult(double x[], double b[]) {
  const std::size_t n = spectrum_.size();
  auto reflect = [&](const std::vector<double>& v) {
    double dot = 0;
    for (std::size_t i = 0; i < n; ++i) dot += v[i] * b[i];
    for (std::size_t i = 0; i < n; ++i) b[i] -= 2 * dot * v[i];
  };
  std::copy(x, x + n, b);
  for (auto v = reflectors_.rbegin(); v != reflectors_.rend(); ++v) reflect(*v);  // Q' x
  for (std::size_t i = 0; i < n; ++i) b[i] *= spectrum_[i];
  for (const std::vector<double>& v : reflectors_) reflect(v);  // Q (...)
}

SparseMatrix scaled(const SparseMatrix& A, double c) {
  std::vector<SparseMatrix::Entry> entries = A.entries();
  for (SparseMatrix::Entry& e : entries) e.value *= c;
  return SparseMatrix(A.rows(), A.cols(), entries);
}

double even_scale(implicitMatrix& A, const std::vector<double>& b) {
  std::vector<double> x = b, Ab(b.size());
  A.matVecMult(x.data(), Ab.data());
  return 2 * std::inner_product(b.begin(), b.end(), Ab.begin(), 0.0) /
         std::inner_product(Ab.begin(), Ab.end(), Ab.begin(), 0.0);
}

PlannedSystem planned_system(const std::vector<double>& curvatures, const std::vector<double>& ratios,
                             const std::vector<double>& mirror) {
  const int n = static_cast<int>(curvatures.size());
  if (static_cast<int>(ratios.size()) != n - 1 || static_cast<int>(mirror.size()) != n)
    throw std::invalid_argument("planned_system: " + std::to_string(n) + " curvatures with " +
                                std::to_string(ratios.size()) + " ratios and a mirror of " +
                                std::to_string(mirror.size()) + " values; need one less and as many");
  // T = L D L'; row 0 of (1 - T) c = r has any number, and the others 0, so c follows from its last entry.
  const auto off = [&](int i) { return -ratios[i] * curvatures[i]; };  // T(i, i + 1)
  const auto main = [&](int i) { return curvatures[i] + (i > 0 ? -ratios[i - 1] * off(i - 1) : 0); };
  std::vector<double> table(n * n), c(n, 1);
  for (int i = n - 1; i >= 0; --i) {
    table[i * n + i] = main(i);
    if (i == 0) break;
    table[i * n + i - 1] = table[(i - 1) * n + i] = off(i - 1);
    c[i - 1] = ((1 - main(i)) * c[i] - (i + 1 < n ? off(i) * c[i + 1] : 0)) / off(i - 1);
  }
  const double squared = std::inner_product(mirror.begin(), mirror.end(), mirror.begin(), 0.0);
  const auto reflect = [&](double* first, int stride) {
    double dot = 0;
    for (int i = 0; i < n; ++i) dot += mirror[i] * first[i * stride];
    for (int i = 0; i < n; ++i) first[i * stride] -= 2 * dot / squared * mirror[i];
  };
  reflect(c.data(), 1);
  for (int i = 0; i < n; ++i) reflect(&table[i], n);
  for (int i = 0; i < n; ++i) reflect(&table[i * n], 1);
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) entries.push_back({i, j, table[i * n + j]});
  return {SparseMatrix(n, n, entries), c};
}

std::vector<double> log_spaced(int n, double low, double high) {
  if (n < 2 || !(low > 0) || !(low <= high))
    throw std::invalid_argument("log_spaced: n = " + std::to_string(n) + ", low = " + std::to_string(low) +
                                ", high = " + std::to_string(high) + "; need n >= 2 and 0 < low <= high");
  std::vector<double> values(n);
  for (int i = 0; i < n; ++i) values[i] = low * std::pow(high / low, static_cast<double>(i) / (n - 1));
  return values;
}

}  // namespace solver
