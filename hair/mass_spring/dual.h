// Dual numbers: a value and its derivative along one direction. A function written for any number type,
// called with x + dx as duals, returns its value and its directional derivative, exact up to rounding.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace hair {

struct Dual {
  double value = 0, change = 0;

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor): a number is a constant
  Dual(double v, double dv) : value(v), change(dv) {}

  Dual& operator+=(const Dual& b) { return *this = {value + b.value, change + b.change}; }
  Dual& operator-=(const Dual& b) { return *this = {value - b.value, change - b.change}; }
  Dual& operator*=(const Dual& b) { return *this = {value * b.value, change * b.value + value * b.change}; }
  Dual& operator/=(const Dual& b) {
    const double quotient = value / b.value;
    return *this = {quotient, (change - quotient * b.change) / b.value};
  }
};

inline Dual operator+(Dual a, const Dual& b) {
  return a += b;
}
inline Dual operator-(Dual a, const Dual& b) {
  return a -= b;
}
inline Dual operator*(Dual a, const Dual& b) {
  return a *= b;
}
inline Dual operator/(Dual a, const Dual& b) {
  return a /= b;
}
inline Dual operator-(const Dual& a) {
  return {-a.value, -a.change};
}

// The derivative of a square root at 0 is infinite: callers must check.
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, a.change / (2 * root)};
}

inline Dual atan2(const Dual& y, const Dual& x) {
  const double squared = x.value * x.value + y.value * y.value;
  return {std::atan2(y.value, x.value), (y.change * x.value - y.value * x.change) / squared};
}

inline double value_of(double a) {
  return a;
}
inline double value_of(const Dual& a) {
  return a.value;
}

}  // namespace hair

namespace Eigen {

// The traits that Eigen requires of a number type.
template <>
struct NumTraits<hair::Dual> : NumTraits<double> {
  using Real = hair::Dual;
  using NonInteger = hair::Dual;
  using Nested = hair::Dual;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 2,
    MulCost = 4
  };
};

}  // namespace Eigen
