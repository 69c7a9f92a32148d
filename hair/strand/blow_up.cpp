#include "hair/strand/blow_up.h"

namespace hair {

namespace {

// The sum of the squares. It has eight partial sums, because a single one would wait for itself at each
// number.
double squares(const Eigen::VectorXd& values) {
  using Eight = Eigen::Array<double, 8, 1>;
  Eight sums = Eight::Zero();
  Eigen::Index i = 0;
  for (; i + 8 <= values.size(); i += 8) sums += values.segment<8>(i).array().square();
  return sums.sum() + values.tail(values.size() - i).squaredNorm();
}

// False for NaN, too. No number exceeds the norm, which is calculated much faster than the largest number.
bool within(const Eigen::VectorXd& values, double bound) {
  return squares(values) <= bound * bound || (values.array().abs() <= bound).all();
}

}  // namespace

bool is_sound(const particles::State& state) {
  return within(state.x, kFarthest) && within(state.v, kFastest);
}

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::integration:
      return "integration";
    case Stage::filter:
      return "filter";
    case Stage::correction:
      return "correction";
    case Stage::second_filter:
      return "second filter";
    case Stage::collision:
      return "collision";
  }
  return "";
}

}  // namespace hair
