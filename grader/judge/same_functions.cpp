// STAFF ONLY. The C library's functions in hairsuite, as on every processor: those for processors with fused
// multiply-adds have other last bits than those for all others. Inputs that are made with them, such as hair
// that lies in curls, would be other inputs. Those of long double have one version; what they round away is
// seen once in thousands of values.
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
