// STAFF ONLY. Structs as JSON, by fields that are declared once: a row has the key and the member, and makes
// the writer and the reader.
//
//   const Rows<CaseResult>& rows_of(As<CaseResult>) {
//     static const Rows<CaseResult> all = {field("name", &CaseResult::name), ...};
//     return all;
//   }
//
// The rows' order is the order in the JSON. A member may be a number, text, a path, an enum, a struct with
// fields of its own, and a list, a map or an optional of these. A reader takes only texts of the writer: for
// a field that is missing, unknown or of another kind it throws BadInput with one line that names the place,
// "NAME: cases[2].status: ...". json_fields.h has field(), the writer and the reader: headers that declare
// Fields do without the JSON library's header, which takes seconds to compile.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "grader/course/input.h"

namespace grader::inline result {

using OrderedJson = nlohmann::ordered_json;

// This is a picture's text in JSON: base64, or the name of a file. `read` throws BadInput or
// std::invalid_argument.
struct PictureText {
  std::function<std::string(const std::string& png)> write;
  std::function<std::string(const std::string& text)> read;
};
PictureText pictures_in_base64();

template <class T>
struct Field {
  std::string key;
  std::function<OrderedJson(const T&, const PictureText&)> write;
  std::function<void(T&, const JsonValue&, const PictureText&)> read;
  std::function<bool(const T&)> there = {};  // true: it is written; empty: always, and then a reader needs it
};

template <class T>
using Rows = std::vector<Field<T>>;

// Each struct with fields has a function rows_of(As<T>) in a namespace of T or As (see result_fields.h), or
// Fields of its own.
template <class T>
struct As {};

template <class T>
struct Fields;

template <class T>
requires requires(As<T> as) {
  rows_of(as);
}
struct Fields<T> {
  static const Rows<T>& rows() { return rows_of(As<T>()); }
};

template <class T>
concept Declared = requires {
  Fields<T>::rows();
};

// This is the last value of an enum. Its values count from 0, and to_string names them.
template <class Enum>
inline constexpr Enum kLast = Enum{};

}  // namespace grader::result
