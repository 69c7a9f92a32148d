// STAFF ONLY. Values in a message: numbers, vectors and matrices, arrays and lists, and structs field by
// field.
//
// A struct has a form, which names its fields once, in the order of the message:
//
//   template <>
//   struct Form<hair::StripLaw> {
//     static constexpr auto fields = std::tuple(&hair::StripLaw::thickness, &hair::StripLaw::stiffness, ...);
//   };
//
// A form may also have check(value), which is called after reading: it throws MalformedMessage for fields
// that do not fit each other, or bounds a number. Senders are hostile: all other numbers may be anything.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "grader/wire/message.h"

namespace grader::inline calls {

template <class T>
struct Form;

template <class T>
concept Formed = requires {
  Form<T>::fields;
};
template <class T>
concept DenseNumbers = requires {
  typename T::PlainObject;
  T::SizeAtCompileTime;
};

// Both sides know the sizes of these, so they are not sent.
template <class T>
inline constexpr bool kFixedLength = false;
template <class T, std::size_t n>
inline constexpr bool kFixedLength<std::array<T, n>> = true;

template <class T>
void encode(MessageWriter& message, const T& value) {
  if constexpr (std::is_enum_v<T>) {
    message.put(static_cast<int>(value));
  } else if constexpr (std::is_same_v<T, bool>) {
    message.put(static_cast<std::uint8_t>(value));
  } else if constexpr (std::is_arithmetic_v<T>) {
    message.put(value);
  } else if constexpr (DenseNumbers<T>) {
    if constexpr (T::SizeAtCompileTime != Eigen::Dynamic) {
      for (const double number : value.reshaped()) message.put(number);
    } else {
      if constexpr (T::ColsAtCompileTime != 1)
        message.put(static_cast<int>(value.rows())).put(static_cast<int>(value.cols()));
      // Copies them if they do not lie side by side.
      const Eigen::Ref<const typename T::PlainObject>& numbers = value;
      message.put(std::span<const double>(numbers.data(), static_cast<std::size_t>(numbers.size())));
    }
  } else if constexpr (Formed<T>) {
    std::apply([&](auto... field) { (encode(message, value.*field), ...); }, Form<T>::fields);
  } else {
    if constexpr (!kFixedLength<T>) message.put(static_cast<std::uint64_t>(value.size()));
    for (const auto& item : value) encode(message, item);
  }
}

// Throws MalformedMessage for a message that is too short, and for a value that a form's check refuses.
template <class T>
void decode(MessageReader& message, T& value) {
  if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(message.get<int>());
  } else if constexpr (std::is_same_v<T, bool>) {
    const auto byte = message.get<std::uint8_t>();
    if (byte > 1) throw MalformedMessage("neither false nor true");
    value = byte == 1;
  } else if constexpr (std::is_arithmetic_v<T>) {
    value = message.get<T>();
  } else if constexpr (DenseNumbers<T>) {
    if constexpr (T::SizeAtCompileTime != Eigen::Dynamic) {
      for (double& number : value.reshaped()) number = message.get<double>();
    } else if constexpr (T::ColsAtCompileTime == 1) {
      const std::vector<double> numbers = message.get_doubles();
      value = Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
    } else {
      const int rows = message.get<int>(), columns = message.get<int>();
      if (rows < 0 || columns < 0) throw MalformedMessage("a matrix of fewer than no numbers");
      const auto size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
      value = Eigen::Map<const Eigen::MatrixXd>(message.get_doubles(size).data(), rows, columns);
    }
  } else if constexpr (Formed<T>) {
    std::apply([&](auto... field) { (decode(message, value.*field), ...); }, Form<T>::fields);
    if constexpr (requires { Form<T>::check(value); }) Form<T>::check(value);
  } else if constexpr (kFixedLength<T>) {
    for (auto& item : value) decode(message, item);
  } else {
    const auto count = message.get<std::uint64_t>();
    value.clear();  // grows only with the message's real bytes
    for (std::uint64_t i = 0; i < count; ++i) decode(message, value.emplace_back());
  }
}

// Gives `value` the lengths of `model`: a list or a vector that was made longer or shorter.
template <class T>
void fit(T& value, const T& model) {
  if constexpr (DenseNumbers<T>) {
    if constexpr (T::SizeAtCompileTime == Eigen::Dynamic)
      value.conservativeResize(model.rows(), model.cols());
  } else if constexpr (Formed<T>) {
    std::apply([&](auto... field) { (fit(value.*field, model.*field), ...); }, Form<T>::fields);
  } else if constexpr (requires { value.resize(model.size()); }) {
    value.resize(model.size());
    for (std::size_t i = 0; i < model.size(); ++i) fit(value[i], model[i]);
  }
}

// Throws MalformedMessage if lengths differ from those of `model`.
template <class T>
void expect_like(const T& value, const T& model) {
  if constexpr (DenseNumbers<T>) {
    if (value.rows() != model.rows() || value.cols() != model.cols())
      throw MalformedMessage("an array of " + std::to_string(value.size()) + " numbers; expected " +
                             std::to_string(model.size()));
  } else if constexpr (Formed<T>) {
    std::apply([&](auto... field) { (expect_like(value.*field, model.*field), ...); }, Form<T>::fields);
  } else if constexpr (requires { value.size(); }) {
    if (value.size() != model.size()) throw MalformedMessage("a list of another length");
    for (std::size_t i = 0; i < model.size(); ++i) expect_like(value[i], model[i]);
  }
}

}  // namespace grader::calls
