// STAFF ONLY. make_samples puts the rest of this file in the place of its #include: a hand-in is one file.
// A number with its derivative; a dual of duals has second derivatives.
template <class T>
struct Dual {
  T v, d;
  Dual(double c = 0) : v(c), d(0) {}
  Dual(T value, T change) : v(value), d(change) {}
};
template <class T>
Dual<T> operator+(const Dual<T>& a, const Dual<T>& b) {
  return {a.v + b.v, a.d + b.d};
}
template <class T>
Dual<T> operator-(const Dual<T>& a, const Dual<T>& b) {
  return {a.v - b.v, a.d - b.d};
}
template <class T>
Dual<T> operator*(const Dual<T>& a, const Dual<T>& b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d};
}
template <class T>
Dual<T> operator/(const Dual<T>& a, const Dual<T>& b) {
  return {a.v / b.v, (a.d - a.v / b.v * b.d) / b.v};
}
using std::sqrt;
template <class T>
Dual<T> sqrt(const Dual<T>& a) {
  T r = sqrt(a.v);
  return {r, a.d / (T(2) * r)};
}

using D1 = Dual<double>;
using D2 = Dual<D1>;

template <class T>
using Vec = std::array<T, 3>;
template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
