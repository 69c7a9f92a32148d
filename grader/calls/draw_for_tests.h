// STAFF ONLY. For tests: makes requests of any call, with random numbers and lengths, and a server that
// answers anything. Many requests do not fit.
#pragma once

#include <algorithm>
#include <limits>
#include <random>

#include "grader/calls/server.h"
#include "reference/H10/calls.h"

namespace grader::draw {

class Source {
 public:
  explicit Source(int seed) : bits_(static_cast<unsigned>(seed)) {}

  int integer(int least, int most) { return std::uniform_int_distribution(least, most)(bits_); }
  double number() {
    constexpr double kOdd[] = {-0.0, std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN(), 1e300};
    return integer(0, 9) == 0 ? kOdd[integer(0, 3)] : std::normal_distribution()(bits_);
  }

  // Chooses a call's number of particles; most of its lengths and indices follow from that.
  void draw_particles() { particles_ = integer(0, 3); }
  int particles() const { return particles_; }
  int length() { return integer(0, 1) == 0 ? 3 * particles_ : std::max(0, particles_ - integer(0, 1)); }
  int index() { return integer(0, 9) == 0 ? integer(-2, 3) : integer(0, std::max(0, particles_ - 1)); }

 private:
  std::mt19937_64 bits_;
  int particles_ = 0;
};

template <class T>
T any(Source& source) {
  T value{};
  if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(source.integer(0, 1));
  } else if constexpr (std::is_floating_point_v<T>) {
    value = source.number();
  } else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, char>) {
    value = static_cast<T>(source.integer(0, 1));
  } else if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(source.index());
  } else if constexpr (DenseNumbers<T>) {
    if constexpr (T::SizeAtCompileTime == Eigen::Dynamic)
      value.resize(source.length(), T::ColsAtCompileTime == 1 ? 1 : source.length());
    for (double& number : value.reshaped()) number = source.number();
  } else if constexpr (Formed<T>) {
    const auto draw = [&](auto& field) { field = any<std::remove_cvref_t<decltype(field)>>(source); };
    std::apply([&](auto... field) { (draw(value.*field), ...); }, Form<T>::fields);
  } else {
    if constexpr (!kFixedLength<T>) value.resize(static_cast<std::size_t>(source.length()));
    for (auto& item : value) item = any<std::remove_cvref_t<decltype(item)>>(source);
  }
  return value;
}

template <class P, Contract contract>
struct Parameter {
  static void put(MessageWriter& request, Source& source) {
    if constexpr (std::is_same_v<P, particles::Input>) {
      encode(request, any<Eigen::VectorXd>(source));
    } else if constexpr (std::is_same_v<P, particles::Output>) {
      if constexpr (contract.may_share) request.put(source.integer(0, 4));
      encode(request, any<Eigen::VectorXd>(source));
    } else if constexpr (std::is_same_v<P, particles::Scratch>) {
      if constexpr (contract.scratch_columns == 0)
        encode(request, any<Eigen::MatrixXd>(source));
      else
        request.put(contract.scratch_columns + source.integer(-1, 4)).put(source.number());
    } else if constexpr (std::is_same_v<P, const particles::Force&>) {
      request.put(std::uint8_t{0});
    } else if constexpr (std::is_same_v<P, Operator>) {
      request.put(source.integer(-1, 2)).put(source.length()).put(source.length());
    } else if constexpr (!std::is_same_v<P, particles::Dynamics&> && !std::is_same_v<P, implicitMatrix&>) {
      encode(request, any<std::remove_cvref_t<P>>(source));
    }
  }
};
template <class Item, Contract contract>
struct Parameter<std::span<const Item>, contract> {
  static void put(MessageWriter& request, Source& source) { encode(request, any<std::vector<Item>>(source)); }
};

// Guides refer to points that another object keeps.
template <Contract contract>
struct Parameter<const std::array<hair::GuideHair, 3>&, contract> {
  static void put(MessageWriter& request, Source& source) {
    for (int k = 0; k < 3; ++k) {
      encode(request, any<hair::RootFrame>(source));
      encode(request, any<Eigen::VectorXd>(source));
    }
  }
};

// Makes a request of call number `number`.
template <class Calls, int number>
std::vector<std::byte> request(Source& source) {
  using Call = typename Calls::template At<number>;
  source.draw_particles();
  MessageWriter message;
  message.put(number);
  const auto put_arguments = [&]<class... P>(std::type_identity<std::tuple<P...>>) {
    (Parameter<P, Call::contract>::put(message, source), ...);
  };
  const std::type_identity<typename Call::Signature::Parameters> parameters;
  put_arguments(parameters);
  if constexpr (Call::Signature::returns_matrix) {
    const int after = source.integer(0, 1);
    message.put(static_cast<std::uint8_t>(after));
    if (after != 0) put_arguments(parameters);
    encode(message, any<Eigen::VectorXd>(source));
    encode(message, any<Eigen::VectorXd>(source));
    message.put(static_cast<std::uint8_t>(source.integer(0, 2)));
  }
  return message.bytes();
}

// This is a host whose functions return anything and change nothing.
class Idle {
 public:
  using Vector = UnguardedVector;

  explicit Idle(Source& source) : source_(source) {}

  void ask(const Question&) {}
  template <class Call, class... Arguments>
  typename Call::Signature::Result call(Arguments&&...) {
    if constexpr (Call::Signature::returns_matrix)
      return std::make_unique<Nowhere>();
    else if constexpr (!std::is_void_v<typename Call::Signature::Result>)
      return any<typename Call::Signature::Result>(source_);
  }
  void bound(int&, Eigen::Index) {}
  void served(const particles::Force&) {}

 private:
  struct Nowhere : implicitMatrix {
    void matVecMult(double[], double[]) override {}
  };

  Source& source_;
};

}  // namespace grader::draw
