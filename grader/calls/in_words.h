// STAFF ONLY. Writes a call as staff read it next to an error: "frame_at({(0.1, 0, 0.2), 9 numbers up to
// 0.9}, (3, 50, 1), 0.012)"; and its values as C++.
#pragma once

#include <charconv>
#include <functional>
#include <ranges>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grader/calls/form.h"

namespace grader::inline calls {

// Takes the function's name without namespaces from GCC's and Clang's text of a template's arguments.
template <auto function>
std::string_view name_of() {
  const char* said = __PRETTY_FUNCTION__;
  std::string_view text = said;
  text = text.substr(text.find("function = "));
  text = text.substr(0, text.find_first_of(";]()", 12));
  return text.substr(text.find_last_of(": &") + 1);
}

// The first item of a list represents the others. Objects that answer questions, and scratch memory, are left
// out.
template <class T>
void tell(std::ostream& out, const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    out << +value;
  } else if constexpr (std::is_enum_v<T>) {
    out << static_cast<int>(value);
  } else if constexpr (DenseNumbers<T>) {
    if (value.size() <= 4) {
      const char* comma = "(";
      for (const double number : value.reshaped()) out << std::exchange(comma, ", ") << number;
      out << (value.size() == 0 ? "()" : ")");
    } else {
      out << value.size() << " numbers up to " << value.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
    }
  } else if constexpr (Formed<T>) {
    const char* comma = "{";
    std::apply([&](auto... field) { ((out << std::exchange(comma, ", "), tell(out, value.*field)), ...); },
               Form<T>::fields);
    out << "}";
  } else if constexpr (requires { value.size(); }) {
    const bool all = value.size() <= (std::is_arithmetic_v<std::ranges::range_value_t<T>> ? 4 : 1);
    if (!all) out << value.size() << " of ";
    const char* comma = "[";
    for (const auto& item : value) {
      out << std::exchange(comma, ", ");
      tell(out, item);
      if (!all) break;
    }
    out << (value.size() == 0 ? "[]" : "]");
  } else if constexpr (requires { value.get(); }) {
    tell(out, value.get());
  } else {
    out << "...";
  }
}

template <auto function>
std::string in_words(const auto&... arguments) {
  std::ostringstream out;
  out << name_of<function>();
  const char* comma = "(";
  ((out << std::exchange(comma, ", "), tell(out, arguments)), ...);
  out << ")";
  return out.str();
}

// ---- Values as C++, by their forms: an expression that makes a value, and the paths of its numbers. The
// expressions use vector(), matrix() and kept() of grader/judge/replay.h. ----

// Takes the type from GCC's and Clang's text of a template's arguments.
template <class T>
std::string_view type_name() {
  std::string_view text = __PRETTY_FUNCTION__;
  text = text.substr(text.find("T = ") + 4);
  return text.substr(0, text.find_first_of(";]"));
}

// Reads back as the same number, but for the bits of a NaN.
inline std::string number_literal(double number) {
  if (number != number) return "NAN";
  if (std::abs(number) == std::numeric_limits<double>::infinity())
    return number < 0 ? "-INFINITY" : "INFINITY";
  char digits[32];
  std::string text(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

template <class List, class Write>
std::string joined(const List& list, const Write& write) {
  std::string text, line;
  for (const auto& item : list) {
    const std::string next = write(item);
    const bool full = !line.empty() && line.size() + next.size() > 100;
    if (full) text += line + ",\n        ", line.clear();
    line += (line.empty() ? "" : ", ") + next;
  }
  return "{" + text + line + "}";
}

template <class T>
std::string literal(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_enum_v<T>) {
    return std::string(type_name<T>()) + "(" + std::to_string(static_cast<int>(value)) + ")";
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(value);
  } else if constexpr (std::is_floating_point_v<T>) {
    return number_literal(value);
  } else if constexpr (DenseNumbers<T>) {
    const std::string numbers = joined(value.reshaped(), number_literal);
    if constexpr (!std::is_same_v<T, typename T::PlainObject>) return "kept(" + numbers + ")";
    if constexpr (T::ColsAtCompileTime == 1) return "vector(" + numbers + ")";
    return "matrix(" + std::to_string(value.rows()) + ", " + std::to_string(value.cols()) + ", " + numbers +
           ")";
  } else if constexpr (Formed<T>) {
    std::string fields;
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      constexpr auto all = Form<T>::fields;
      ((fields += (i == 0 ? "." : ",\n        .") + std::string(name_of<std::get<i>(all)>()) + " = " +
                  literal(value.*std::get<i>(all))),
       ...);
    }
    (std::make_index_sequence<std::tuple_size_v<decltype(Form<T>::fields)>>());
    return std::string(type_name<T>()) + "{" + fields + "}";
  } else {
    return std::string(type_name<T>()) +
           joined(value, [](const auto& item) { return literal(std::remove_cvref_t<decltype(item)>(item)); });
  }
}

using Leaf = std::function<void(const std::string& path, const std::vector<double>& numbers)>;

// Visits a value's numbers by their paths: "state.x".
template <class T>
void for_each_leaf(const std::string& path, const T& value, const Leaf& leaf) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    leaf(path, {static_cast<double>(value)});
  } else if constexpr (DenseNumbers<T>) {
    const typename T::PlainObject& numbers = value;
    leaf(path, {numbers.data(), numbers.data() + numbers.size()});
  } else if constexpr (Formed<T>) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      constexpr auto all = Form<T>::fields;
      (for_each_leaf(path + "." + std::string(name_of<std::get<i>(all)>()), value.*std::get<i>(all), leaf),
       ...);
    }
    (std::make_index_sequence<std::tuple_size_v<decltype(Form<T>::fields)>>());
  } else if constexpr (std::is_arithmetic_v<std::ranges::range_value_t<T>>) {
    leaf(path, {value.begin(), value.end()});
  } else {
    std::size_t number = 0;
    for (const auto& item : value) for_each_leaf(path + "[" + std::to_string(number++) + "]", item, leaf);
  }
}

}  // namespace grader::calls
