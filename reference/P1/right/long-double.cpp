// STAFF ONLY. A right P1 in long double: accelerations alone are asked for, and given, in doubles.
#include "particles/explicit_integrators.h"

namespace {

using particles::Dynamics;
using particles::Output;

using Long = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

Long accelerations(Dynamics& dynamics, const Long& x, const Long& v) {
  const Eigen::VectorXd at = x.cast<double>(), with = v.cast<double>();
  Eigen::VectorXd a(x.size());
  dynamics.acceleration(at, with, a);
  return a.cast<long double>();
}

struct Motion {
  Long x, v;

  Motion(const Output& from, const Output& speed)
      : x(from.cast<long double>()), v(speed.cast<long double>()) {}
  void put(Output to, Output speed) const {
    to = x.cast<double>();
    speed = v.cast<double>();
  }
};

}  // namespace

namespace particles {

void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch /*scratch*/) {
  Motion now(x, v);
  const Long a = accelerations(dynamics, now.x, now.v);
  now.x += h * now.v;
  now.v += h * a;
  now.put(x, v);
}

void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch /*scratch*/) {
  Motion now(x, v);
  now.v += h * accelerations(dynamics, now.x, now.v);
  now.x += h * now.v;
  now.put(x, v);
}

void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch /*scratch*/) {
  Motion now(x, v), half = now;
  half.v += h / 2 * accelerations(dynamics, now.x, now.v);
  half.x += h / 2 * now.v;
  now.v += h * accelerations(dynamics, half.x, half.v);
  now.x += h * half.v;
  now.put(x, v);
}

// Of x'' = a the slopes of x are velocities, so that the stages' velocities are all that is needed of them.
void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch /*scratch*/) {
  Motion now(x, v);
  const long double half = h / 2.0L;
  const Long v1 = now.v, a1 = accelerations(dynamics, now.x, v1);
  const Long v2 = v1 + half * a1, a2 = accelerations(dynamics, now.x + half * v1, v2);
  const Long v3 = v1 + half * a2, a3 = accelerations(dynamics, now.x + half * v2, v3);
  const Long v4 = v1 + h * a3, a4 = accelerations(dynamics, now.x + h * v3, v4);
  now.x += h * (v1 + 2 * (v2 + v3) + v4) / 6;
  now.v += h * (a1 + 2 * (a2 + a3) + a4) / 6;
  now.put(x, v);
}

}  // namespace particles
