#include "solver/matrix_market.h"

#include <fstream>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace solver {

namespace {

const char* const kMatrix = "%%MatrixMarket matrix coordinate real general";
const char* const kVector = "%%MatrixMarket matrix array real general";

// The numbers of a file behind its header.
class Numbers {
 public:
  Numbers(const std::string& path, const std::string& header) : path_(path), in_(path) {
    in_.imbue(std::locale::classic());
    std::string line;
    if (!std::getline(in_, line) || line != header) fail("it does not begin with " + header);
  }
  template <class Number>
  Number next() {
    Number number;
    if (!(in_ >> number)) fail("a number is missing");
    return number;
  }
  void end() {
    if (std::string more; in_ >> more) fail("there are more numbers than it says");
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(path_ + ": " + what + "; restore it from the handout");
  }

 private:
  std::string path_;
  std::ifstream in_;
};

// Text with a decimal point.
std::ostringstream plain_text() {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  return text;
}

}  // namespace

SparseMatrix read_matrix_market(const std::string& path) {
  Numbers numbers(path, kMatrix);
  const int rows = numbers.next<int>(), cols = numbers.next<int>();
  std::vector<SparseMatrix::Entry> entries;
  for (int left = numbers.next<int>(); left > 0; --left) {
    const int row = numbers.next<int>(), col = numbers.next<int>();
    entries.push_back({row - 1, col - 1, numbers.next<double>()});
  }
  numbers.end();
  return {rows, cols, entries};
}

std::vector<double> read_vector(const std::string& path) {
  Numbers numbers(path, kVector);
  std::vector<double> values;
  const int rows = numbers.next<int>();
  if (numbers.next<int>() != 1) numbers.fail("a vector has one column");
  for (int i = 0; i < rows; ++i) values.push_back(numbers.next<double>());
  numbers.end();
  return values;
}

void write_matrix_market(std::ostream& out, const SparseMatrix& matrix) {
  std::ostringstream text = plain_text();
  const std::vector<SparseMatrix::Entry> entries = matrix.entries();
  text << kMatrix << '\n' << matrix.rows() << ' ' << matrix.cols() << ' ' << entries.size() << '\n';
  for (const auto& [row, col, value] : entries) text << row + 1 << ' ' << col + 1 << ' ' << value << '\n';
  out << text.str();
}

void write_vector(std::ostream& out, const std::vector<double>& values) {
  std::ostringstream text = plain_text();
  text << kVector << '\n' << values.size() << " 1\n";
  for (const double value : values) text << value << '\n';
  out << text.str();
}

}  // namespace solver
