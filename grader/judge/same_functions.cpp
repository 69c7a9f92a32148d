// STAFF ONLY. Gives hairsuite the same functions of the C library on every processor: those for processors
// with fused multiply-adds have other last bits. They would change the inputs that are made with them, such
// as curls. Functions of long double have one version; their rounding to double differs once in thousands of
// values.
#include <cmath>

extern "C" {

double sin(double x) noexcept {
  return static_cast<double>(sinl(x));
}
double cos(double x) noexcept {
  return static_cast<double>(cosl(x));
}
void sincos(double x, double* sine, double* cosine) noexcept {
  *sine = sin(x), *cosine = cos(x);
}
double tan(double x) noexcept {
  return static_cast<double>(tanl(x));
}
double asin(double x) noexcept {
  return static_cast<double>(asinl(x));
}
double acos(double x) noexcept {
  return static_cast<double>(acosl(x));
}
double atan(double x) noexcept {
  return static_cast<double>(atanl(x));
}
double atan2(double y, double x) noexcept {
  return static_cast<double>(atan2l(y, x));
}
double exp(double x) noexcept {
  return static_cast<double>(expl(x));
}
double log(double x) noexcept {
  return static_cast<double>(logl(x));
}
double pow(double x, double y) noexcept {
  return static_cast<double>(powl(x, y));
}

}  // extern "C"
