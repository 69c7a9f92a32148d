#include "solver/matrix_market.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "solver/test_comma_locale.h"
#include "solver/test_refusal.h"

namespace solver {
namespace {

using Vector = std::vector<double>;

// A file with this text.
std::string file_of(const std::string& text) {
  const std::string path = testing::TempDir() + "/hair_matrix_market_test.mtx";
  std::ofstream(path) << text;
  return path;
}

// In a locale with a decimal comma, too.
TEST(MatrixMarket, ReadsBackWhatItWroteBitByBit) {
  const CommaLocale comma(testing::TempDir());
  const Vector hard = {
      1.0 / 3, -0.1, 2e-308, 1.7976931348623157e308, 2.2250738585072014e-308, 0x1.fffffffffffffp-1,
      -0.0,    1e-8};
  std::vector<SparseMatrix::Entry> entries;
  for (int k = 0; k < 8; ++k) entries.push_back({k % 3, 1000 * k, hard[k]});
  std::ostringstream matrix, vector;
  write_matrix_market(matrix, SparseMatrix(3, 8000, entries));
  EXPECT_TRUE(matrix.str().starts_with(
      "%%MatrixMarket matrix coordinate real general\n3 8000 8\n1 1 0.33333333333333331\n"))
      << matrix.str();
  const SparseMatrix back = read_matrix_market(file_of(matrix.str()));
  EXPECT_EQ(back.rows(), 3);
  EXPECT_EQ(back.cols(), 8000);
  ASSERT_EQ(back.entries().size(), 8u);
  for (const auto& e : back.entries())
    EXPECT_EQ(std::memcmp(&e.value, &hard[e.col / 1000], 8), 0) << hard[e.col / 1000];

  write_vector(vector, hard);
  const Vector values = read_vector(file_of(vector.str()));
  ASSERT_EQ(values.size(), hard.size());
  EXPECT_EQ(std::memcmp(values.data(), hard.data(), 8 * hard.size()), 0);
}

TEST(MatrixMarket, RefusesFilesThatItDidNotWrite) {
  const std::string matrix = "%%MatrixMarket matrix coordinate real general\n",
                    vector = "%%MatrixMarket matrix array real general\n";
  for (const std::string& text :
       {std::string(), vector + "1 1\n1\n", matrix + "2 2\n", matrix + "2 2 2\n1 1 1\n",
        matrix + "2 2 1\n3 1 1\n", matrix + "2 2 1\n1 1 nan\n", matrix + "1 1 1\n1 1 1,5\n",
        matrix + "1 1 1\n1 1 1\n1 1 1\n"})
    EXPECT_THROW(read_matrix_market(file_of(text)), std::invalid_argument) << text;
  for (const std::string& text : {matrix + "1 1 1\n1 1 1\n", vector + "1 2\n1\n2\n", vector + "2 1\n1\n",
                                  vector + "1 1\n1\n2\n", vector + "1 1\nx\n"})
    EXPECT_THROW(read_vector(file_of(text)), std::invalid_argument) << text;
  EXPECT_EQ(tests::refusal<std::invalid_argument>([] { read_vector("/nonexistent/b.mtx"); }),
            "/nonexistent/b.mtx: it does not begin with %%MatrixMarket matrix array real general; restore it "
            "from the handout");
}

}  // namespace
}  // namespace solver
