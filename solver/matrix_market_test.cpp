#include "solver/matrix_market.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "solver/test_comma_locale.h"

namespace solver {
namespace {

using Vector = std::vector<double>;

SparseMatrix read(const std::string& text) {
  std::istringstream in(text);
  return read_matrix_market(in, "m.mtx");
}

// The matrix as rows of a full table.
std::vector<Vector> table(const SparseMatrix& A) {
  std::vector<Vector> rows(A.rows(), Vector(A.cols(), 0.0));
  for (const auto& e : A.entries()) rows[e.row][e.col] += e.value;
  return rows;
}

template <class Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was refused";
}

using Table = std::vector<Vector>;
const std::string kGeneral = "%%MatrixMarket matrix coordinate real general\n";

TEST(MatrixMarket, ReadsCoordinatesInAnyOrderWithCommentsAndEmptyLines) {
  EXPECT_EQ(
      table(read(kGeneral +
                 "% a comment\n\n  % and one more\n2 3 3\n2 1 -1.5e0\r\n\n1 3 4\n% here too\n1 3 1\n\n")),
      (Table{{0, 0, 5}, {-1.5, 0, 0}}));
}

TEST(MatrixMarket, ReadsPatternsAndIntegers) {
  EXPECT_EQ(table(read("%%matrixmarket MATRIX Coordinate Pattern General\n2 2 1\n1 2\n")),
            (Table{{0, 1}, {0, 0}}));
  EXPECT_EQ(table(read("%%MatrixMarket matrix coordinate integer general\n1 1 1\n1 1 -7")), (Table{{-7}}));
}

TEST(MatrixMarket, MirrorsTheLowerTriangleOfASymmetricFile) {
  EXPECT_EQ(table(read("%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 3\n2 1 5\n")),
            (Table{{3, 5}, {5, 0}}));
  EXPECT_EQ(table(read("%%MatrixMarket matrix array real symmetric\n3 3\n1\n2\n3\n4\n5\n6\n")),
            (Table{{1, 2, 3}, {2, 4, 5}, {3, 5, 6}}));
}

TEST(MatrixMarket, ReadsArraysByColumns) {
  EXPECT_EQ(table(read("%%MatrixMarket matrix array real general\n2 3\n1\n2\n3\n4\n5\n6\n")),
            (Table{{1, 3, 5}, {2, 4, 6}}));
}

TEST(MatrixMarket, ReadsEmptyMatrices) {
  EXPECT_EQ(read(kGeneral + "0 0 0\n").rows(), 0);
  EXPECT_EQ(read("%%MatrixMarket matrix array real general\n0 1\n").cols(), 1);
  EXPECT_EQ(read("%%MatrixMarket matrix array real symmetric\n0 0\n").rows(), 0);
}

TEST(MatrixMarket, ReadsBackWhatItWroteBitByBit) {
  const Vector hard = {
      1.0 / 3, -0.1, 5e-324, 1.7976931348623157e308, 2.2250738585072014e-308, 0x1.fffffffffffffp-1,
      -0.0,    1e-8};
  std::vector<SparseMatrix::Entry> entries;
  for (int k = 0; k < 8; ++k) entries.push_back({k % 3, k, hard[k]});
  std::stringstream matrix, vector;
  write_matrix_market(matrix, SparseMatrix(3, 8, entries));
  write_vector(vector, hard);
  const SparseMatrix back = read_matrix_market(matrix, "back");
  EXPECT_EQ(back.rows(), 3);
  EXPECT_EQ(back.cols(), 8);
  ASSERT_EQ(back.entries().size(), 8u);
  for (const auto& e : back.entries()) EXPECT_EQ(std::memcmp(&e.value, &hard[e.col], 8), 0) << hard[e.col];
  const Vector values = read_vector(vector, "back");
  ASSERT_EQ(values.size(), hard.size());
  EXPECT_EQ(std::memcmp(values.data(), hard.data(), 8 * hard.size()), 0);
}

TEST(MatrixMarket, DoesNotWriteWhatItWouldNotRead) {
  std::ostringstream out;
  EXPECT_THROW(write_vector(out, {INFINITY}), std::invalid_argument);
  EXPECT_THROW(write_matrix_market(out, diagonal({NAN})), std::invalid_argument);
}

struct Bad {
  std::string text, line, what;  // the message must contain `what`

  friend std::ostream& operator<<(std::ostream& out, const Bad& bad) {
    return out << bad.text.substr(0, 200);
  }
};

class BadMatrix : public testing::TestWithParam<Bad> {};

TEST_P(BadMatrix, IsRefusedInOneLineThatSaysWhereAndWhatWouldBeRight) {
  const std::string message = complaint([&] { read(GetParam().text); });
  EXPECT_EQ(message.find("m.mtx:" + GetParam().line + ": "), 0u) << message;
  EXPECT_NE(message.find(GetParam().what), std::string::npos) << message;
  EXPECT_NE(message.find("need"), std::string::npos) << message;
  EXPECT_TRUE(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; }))
      << message;
  EXPECT_LT(message.size(), 200u) << message;
}

const std::string kArray = "%%MatrixMarket matrix array real general\n";
const std::string kSymmetric = "%%MatrixMarket matrix coordinate real symmetric\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadMatrix,
    testing::Values(
        Bad{"", "0", "empty"}, Bad{"\n", "1", "no Matrix Market header"},
        Bad{"1 1 1\n1 1 1\n", "1", "header"},
        Bad{"%MatrixMarket matrix coordinate real general\n1 1 0\n", "1", "header"},
        Bad{"%%MatrixMarket matrix coordinate real\n1 1 0\n", "1", "header"},
        Bad{"%%MatrixMarket matrix coordinate real general extra\n1 1 0\n", "1", "header"},
        Bad{"%%MatrixMarket vector coordinate real general\n1 1 0\n", "1", "'vector' is not supported"},
        Bad{"%%MatrixMarket matrix sparse real general\n1 1 0\n", "1", "'sparse' is not supported"},
        Bad{"%%MatrixMarket matrix coordinate complex general\n1 1 0\n", "1", "'complex' is not supported"},
        Bad{"%%MatrixMarket matrix array pattern general\n1 1\n", "1", "'pattern' is not supported"},
        Bad{"%%MatrixMarket matrix coordinate real skew-symmetric\n1 1 0\n", "1",
            "'skew-symmetric' is not supported"},
        Bad{"%%MatrixMarket matrix coordinate real hermitian\n1 1 0\n", "1", "'hermitian' is not supported"},
        Bad{kGeneral, "1", "ends before its size"},
        Bad{kGeneral + "% only this\n", "2", "ends before its size"},
        Bad{kGeneral + "2 2\n", "2", "size has 2 numbers"},
        Bad{kGeneral + "2 2 1 1\n", "2", "size has 4 numbers"},
        Bad{kArray + "2 2 4\n", "2", "size has 3 numbers"}, Bad{kGeneral + "two 2 1\n", "2", "'two'"},
        Bad{kGeneral + "2 2.5 1\n", "2", "'2.5'"},
        Bad{kGeneral + "-1 2 0\n", "2", "'-1' rows is out of range"},
        Bad{kGeneral + "2 100000001 0\n", "2", "'100000001' columns is out of range"},
        Bad{kGeneral + "99999999999999999999 2 1\n", "2", "rows is out of range"},
        Bad{kGeneral + "9223372036854775808 2 1\n", "2", "rows is out of range"},
        Bad{kGeneral + "2 2 100000001\n", "2", "entries is out of range"},
        Bad{kArray + "100000000 2\n", "2", "200000000 entries"}, Bad{kSymmetric + "2 3 0\n", "2", "2 x 3"},
        Bad{kGeneral + "2 2 2\n1 1 1\n", "3", "ends after 1 entries"},
        Bad{kGeneral + "9 9 100000000\n1 1 1\n", "3", "ends after 1 entries"},
        Bad{kGeneral + "2 2 1\n1 1 1\n2 2 1\n", "4", "follows the last entry"},
        Bad{kArray + "2 1\n1\n", "3", "ends after 1 entries"}, Bad{kArray + "1 1\n1\n2\n", "4", "follows"},
        Bad{kGeneral + "0 0 1\n1 1 1\n", "3", "outside"},
        Bad{kGeneral + "2 2 1\n0 1 1\n", "3", "row '0' is outside"},
        Bad{kGeneral + "2 2 1\n3 1 1\n", "3", "row '3' is outside"},
        Bad{kGeneral + "2 2 1\n1 3 1\n", "3", "column '3' is outside"},
        Bad{kGeneral + "2 2 1\n1 4294967297 1\n", "3", "column '4294967297' is outside"},
        Bad{kGeneral + "2 2 1\n1 x 1\n", "3", "column 'x'"},
        Bad{kGeneral + "2 2 1\n1 1\n", "3", "entry has 2 words"},
        Bad{kGeneral + "2 2 1\n1 1 1 0\n", "3", "entry has 4 words"},
        Bad{kArray + "1 1\n1 2\n", "3", "has 2 words"},
        Bad{kGeneral + "2 2 1\n1 1 1.5z\n", "3", "'1.5z' is no number"},
        Bad{kGeneral + "2 2 1\n1 1 nan\n", "3", "'nan' is not finite"},
        Bad{kGeneral + "2 2 1\n1 1 -inf\n", "3", "'-inf' is not finite"},
        Bad{kGeneral + "2 2 1\n1 1 1e999\n", "3", "'1e999' is not finite"},
        Bad{"%%MatrixMarket matrix coordinate integer general\n1 1 1\n1 1 1.5\n", "3", "no whole number"},
        Bad{"%%MatrixMarket matrix coordinate integer general\n1 1 1\n1 1 9007199254740993\n", "3",
            "may lose digits"},
        Bad{kGeneral + std::string("1 1 1\n1 1 1.5\0x\n", 16), "3", "is no number"},
        Bad{kSymmetric + "2 2 1\n1 2 1\n", "3", "above the diagonal"},
        Bad{kGeneral + "2 2 1\n1 1 \x1b[31m" + std::string(5000, 'a') + "\n", "3", "is no number"}));

TEST(MatrixMarketVector, TakesOneColumnOnly) {
  std::istringstream two("%%MatrixMarket matrix array real general\n1 2\n1\n2\n");
  EXPECT_EQ(complaint([&] { read_vector(two, "v"); }), "v:2: the matrix is 1 x 2; a vector has one column");
}

TEST(MatrixMarketFile, NamesAFileThatIsNotThere) {
  for (const char* path : {"/nonexistent/a.mtx", "/"}) {
    EXPECT_EQ(complaint([&] { read_matrix_market(path); }).find(std::string(path) + ":0: "), 0u);
    EXPECT_EQ(complaint([&] { read_vector(path); }).find(std::string(path) + ":0: "), 0u);
  }
}

TEST(MatrixMarketFile, HasADecimalPointWhateverTheLocale) {
  const CommaLocale comma(testing::TempDir());
  if (!comma.is_everywhere()) GTEST_SKIP() << "the package locales is missing";
  const Vector values(1500, -1.5e-3);
  std::ostringstream written;
  write_vector(written, values);
  EXPECT_EQ(written.str().substr(0, 60), "%%MatrixMarket matrix array real general\n1500 1\n-0.0015\n-0.0");
  std::istringstream in(written.str());
  EXPECT_EQ(read_vector(in, "v"), values);
  std::ostringstream matrix;
  write_matrix_market(matrix, SparseMatrix(2000, 2000, {{1233, 1999, 0.5}}));
  EXPECT_TRUE(matrix.str().ends_with("\n2000 2000 1\n1234 2000 0.5\n")) << matrix.str();
  EXPECT_EQ(complaint([] { read(kArray + "1 1\n1,5\n"); }),
            "m.mtx:3: '1,5' is no number; need one such as -1.5e3");
}

TEST(MatrixMarketFile, IsReadLikeAStream) {
  const std::string path = testing::TempDir() + "/hair_matrix_market_test.mtx";
  std::ofstream(path) << "%%MatrixMarket matrix array real general\n2 1\n1\n2\n";
  EXPECT_EQ(read_vector(path), (Vector{1, 2}));
  EXPECT_EQ(table(read_matrix_market(path)), (Table{{1}, {2}}));
  std::remove(path.c_str());
}

}  // namespace
}  // namespace solver
