// STAFF ONLY. Writes a call as staff read it next to an error: "frame_at({(0.1, 0, 0.2), 9 numbers up to
// 0.9}, (3, 50, 1), 0.012)".
#pragma once

#include <ranges>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

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

}  // namespace grader::calls
