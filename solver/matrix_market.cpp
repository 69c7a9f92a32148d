#include "solver/matrix_market.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "solver/decimal_point.h"

namespace solver {

namespace {

constexpr long long kMost = 100'000'000;
constexpr double kMostWhole = 9007199254740992;  // 2^53: a double holds all whole numbers below

using Entry = SparseMatrix::Entry;

// A token for a message: printable and short.
std::string quoted(std::string token) {
  for (char& c : token)
    if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
  if (token.size() > 40) token = token.substr(0, 37) + "...";
  return "'" + token + "'";
}

// The lines of a file as lists of words, with the present position for messages.
class Lines {
 public:
  Lines(std::istream& in, const std::string& name) : in_(in), name_(name) {}

  // The words of the next line of any kind; false at the end.
  bool next(std::vector<std::string>& words) {
    std::string line;
    if (!std::getline(in_, line)) {
      if (in_.bad()) fail("reading failed; a readable file is needed");
      return false;
    }
    ++number_;
    std::istringstream split(line);
    words.clear();
    for (std::string word; split >> word;) words.push_back(word);
    return true;
  }

  // The same without comments and empty lines.
  bool next_data(std::vector<std::string>& words) {
    while (next(words))
      if (!words.empty() && words[0][0] != '%') return true;
    return false;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(name_ + ":" + std::to_string(number_) + ": " + what);
  }

  long long count(const std::string& word, const std::string& of) const {
    long long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::invalid_argument || end != word.data() + word.size())
      fail(quoted(word) + " is no number of " + of + "; need a whole number from 0 to 100000000");
    if (error == std::errc::result_out_of_range || value < 0 || value > kMost)
      fail(quoted(word) + " " + of + " is out of range; need 0 to 100000000");
    return value;
  }

  int index(const std::string& word, const std::string& of, int size) const {
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value < 1 || value > size)
      fail(of + " " + quoted(word) + " is outside of the matrix; need a whole number from 1 to " +
           std::to_string(size));
    return value - 1;
  }

  double value(const std::string& word, bool integer) const {
    const DecimalPoint point;
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (end != word.c_str() + word.size()) fail(quoted(word) + " is no number; need one such as -1.5e3");
    if (!std::isfinite(value)) fail(quoted(word) + " is not finite; need a number below 1.8e308 in size");
    if (integer && value != std::floor(value))
      fail(quoted(word) + " is no whole number; need one, or 'real' in line 1");
    if (integer && std::abs(value) >= kMostWhole)
      fail(quoted(word) +
           " may lose digits; need a whole number of at most 9007199254740991 in size, or 'real' in line 1");
    return value;
  }

 private:
  std::istream& in_;
  std::string name_;
  long long number_ = 0;
};

struct Header {
  bool coordinate, integer, pattern, symmetric;
};

Header read_header(Lines& lines) {
  static constexpr const char* kExample =
      "; need '%%MatrixMarket matrix coordinate real general' or the like";
  std::vector<std::string> words;
  if (!lines.next(words)) lines.fail(std::string("the file is empty") + kExample);
  for (std::string& word : words)
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (words.size() != 5 || words[0] != "%%matrixmarket")
    lines.fail(std::string("this is no Matrix Market header") + kExample);
  auto one_of = [&](int at, std::initializer_list<const char*> allowed) {
    if (std::find(allowed.begin(), allowed.end(), words[at]) != allowed.end()) return;
    std::string list;
    for (const char* word : allowed) list += (list.empty() ? "'" : " or '") + std::string(word) + "'";
    lines.fail(quoted(words[at]) + " is not supported; need " + list);
  };
  one_of(1, {"matrix"});
  one_of(2, {"coordinate", "array"});
  if (words[2] == "array")
    one_of(3, {"real", "integer"});
  else
    one_of(3, {"real", "integer", "pattern"});
  one_of(4, {"general", "symmetric"});
  return {words[2] == "coordinate", words[3] == "integer", words[3] == "pattern", words[4] == "symmetric"};
}

SparseMatrix read(Lines& lines, bool vector) {
  const Header header = read_header(lines);
  std::vector<std::string> words;
  const std::size_t sizes = header.coordinate ? 3 : 2;
  const std::string size_line = header.coordinate ? "'rows columns entries'" : "'rows columns'";
  if (!lines.next_data(words)) lines.fail("the file ends before its size; need a line " + size_line);
  if (words.size() != sizes)
    lines.fail("the size has " + std::to_string(words.size()) + " numbers; need " + size_line);
  const int rows = static_cast<int>(lines.count(words[0], "rows"));
  const int cols = static_cast<int>(lines.count(words[1], "columns"));
  const std::string size = std::to_string(rows) + " x " + std::to_string(cols);
  if (header.symmetric && rows != cols)
    lines.fail("the matrix is symmetric and " + size + "; need as many rows as columns");
  if (vector && cols != 1) lines.fail("the matrix is " + size + "; a vector has one column");
  const long long places = static_cast<long long>(rows) * cols;
  const long long listed = header.coordinate  ? lines.count(words[2], "entries")
                           : header.symmetric ? (places + rows) / 2
                                              : places;
  if (listed > kMost)
    lines.fail("a full matrix of " + size + " has " + std::to_string(listed) +
               " entries; need at most 100000000");

  std::vector<Entry> entries;
  entries.reserve(std::min(listed, 1'000'000LL));  // a wrong size must not take the memory that it claims
  const std::size_t expected = !header.coordinate ? 1 : header.pattern ? 2 : 3;
  int row = 0, col = 0;  // the next entry's: by columns, a symmetric matrix's from the diagonal down
  for (long long k = 0; k < listed; ++k) {
    if (!lines.next_data(words))
      lines.fail("the file ends after " + std::to_string(k) + " entries; need " + std::to_string(listed));
    if (words.size() != expected)
      lines.fail("an entry has " + std::to_string(words.size()) + " words; need " +
                 (expected == 1   ? "'value'"
                  : expected == 2 ? "'row column'"
                                  : "'row column value'"));
    if (header.coordinate) {
      row = lines.index(words[0], "row", rows);
      col = lines.index(words[1], "column", cols);
      if (header.symmetric && row < col)
        lines.fail(
            "entry (" + words[0] + ", " + words[1] +
            ") lies above the diagonal; need row >= column, since a symmetric file lists the lower triangle");
    }
    const double value = header.pattern ? 1 : lines.value(words.back(), header.integer);
    entries.push_back({row, col, value});
    if (header.symmetric && row != col) entries.push_back({col, row, value});
    if (!header.coordinate && ++row == rows) {
      ++col;
      row = header.symmetric ? col : 0;
    }
  }
  if (lines.next_data(words))
    lines.fail(quoted(words[0]) + " follows the last entry; need exactly " + std::to_string(listed) +
               " entries");
  return SparseMatrix(rows, cols, entries);
}

std::ifstream open(const std::string& path) {
  std::ifstream in(path);
  if (!in)
    throw std::invalid_argument(path + ":0: the file can't be opened; need one that is there and readable");
  return in;
}

std::string digits(double value) {
  if (!std::isfinite(value))
    throw std::invalid_argument("Matrix Market: the value " + std::to_string(value) +
                                " can't be written; need finite ones");
  char text[32];
  const DecimalPoint point;
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace

SparseMatrix read_matrix_market(std::istream& in, const std::string& name) {
  Lines lines(in, name);
  return read(lines, false);
}

SparseMatrix read_matrix_market(const std::string& path) {
  std::ifstream in = open(path);
  return read_matrix_market(in, path);
}

void write_matrix_market(std::ostream& out, const SparseMatrix& matrix) {
  const std::vector<Entry> entries = matrix.entries();
  out << "%%MatrixMarket matrix coordinate real general\n"
      << std::to_string(matrix.rows()) << ' ' << std::to_string(matrix.cols()) << ' '
      << std::to_string(entries.size()) << '\n';
  for (const Entry& e : entries)
    out << std::to_string(e.row + 1) << ' ' << std::to_string(e.col + 1) << ' ' << digits(e.value) << '\n';
}

std::vector<double> read_vector(std::istream& in, const std::string& name) {
  Lines lines(in, name);
  const SparseMatrix matrix = read(lines, true);
  std::vector<double> values(matrix.rows());
  for (const Entry& e : matrix.entries()) values[e.row] = e.value;
  return values;
}

std::vector<double> read_vector(const std::string& path) {
  std::ifstream in = open(path);
  return read_vector(in, path);
}

void write_vector(std::ostream& out, const std::vector<double>& values) {
  out << "%%MatrixMarket matrix array real general\n" << std::to_string(values.size()) << " 1\n";
  for (double value : values) out << digits(value) << '\n';
}

}  // namespace solver
