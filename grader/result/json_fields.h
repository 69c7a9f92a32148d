// STAFF ONLY. Makes fields of members, and writes and reads structs that have declared fields (fields.h).
#pragma once

#include <concepts>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "grader/result/fields.h"
#include "hair/io/plot/readable.h"

namespace grader::inline result {

template <class Enum>
std::vector<std::string> words() {
  std::vector<std::string> all;
  for (int i = 0; i <= static_cast<int>(kLast<Enum>); ++i) all.push_back(to_string(static_cast<Enum>(i)));
  return all;
}

template <class T>
concept MapOfText = requires {
  typename T::mapped_type;
}
&&std::same_as<typename T::key_type, std::string>;
template <class T>
inline constexpr bool kOptional = false;
template <class T>
inline constexpr bool kOptional<std::optional<T>> = true;

template <class T>
OrderedJson to_json_value(const T& value, const PictureText& pictures) {
  if constexpr (Declared<T>) {
    OrderedJson all = OrderedJson::object();
    for (const Field<T>& row : Fields<T>::rows())
      if (!row.there || row.there(value)) all[row.key] = row.write(value, pictures);
    return all;
  } else if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else if constexpr (std::is_enum_v<T>) {
    return to_string(value);
  } else if constexpr (std::same_as<T, std::string>) {
    return hair::valid_utf8(value);
  } else if constexpr (std::same_as<T, std::filesystem::path>) {
    return value.string();
  } else if constexpr (kOptional<T>) {
    return value ? to_json_value(*value, pictures) : OrderedJson();
  } else if constexpr (MapOfText<T>) {
    OrderedJson all = OrderedJson::object();
    for (const auto& [key, item] : value) all[hair::valid_utf8(key)] = to_json_value(item, pictures);
    return all;
  } else {
    OrderedJson all = OrderedJson::array();
    for (const auto& item : value) all.push_back(to_json_value(item, pictures));
    return all;
  }
}

template <std::integral T>
T whole_number(const JsonValue& at) {
  const nlohmann::json& json = at.value();
  if (json.is_number_unsigned() && std::in_range<T>(json.get<std::uint64_t>())) return json.get<T>();
  if (json.is_number_integer() && !json.is_number_unsigned() && std::in_range<T>(json.get<std::int64_t>()))
    return json.get<T>();
  at.fail(at.shown() + " is not right; write a whole number from " +
          std::to_string(std::numeric_limits<T>::min()) + " to " +
          std::to_string(std::numeric_limits<T>::max()));
}

template <class T>
void from_json_value(T& value, const JsonValue& at, const PictureText& pictures) {
  if constexpr (Declared<T>) {
    std::vector<std::string_view> required, optional;
    for (const Field<T>& row : Fields<T>::rows()) (row.there ? optional : required).push_back(row.key);
    at.check_keys(required, optional);
    for (const Field<T>& row : Fields<T>::rows())
      if (at.has(row.key)) row.read(value, at[row.key], pictures);
  } else if constexpr (std::same_as<T, bool>) {
    value = at.boolean();
  } else if constexpr (std::integral<T>) {
    value = whole_number<T>(at);
  } else if constexpr (std::floating_point<T>) {
    if (!at.value().is_number()) at.fail(at.shown() + " is not a number; write one");
    value = at.value().get<T>();
  } else if constexpr (std::is_enum_v<T>) {
    static const std::vector<std::string> all = words<T>();
    static const std::vector<std::string_view> known(all.begin(), all.end());
    value = static_cast<T>(at.word(known));
  } else if constexpr (std::same_as<T, std::string> || std::same_as<T, std::filesystem::path>) {
    value = at.any_text();
  } else if constexpr (kOptional<T>) {
    value.reset();
    if (!at.is_null()) from_json_value(value.emplace(), at, pictures);
  } else if constexpr (MapOfText<T>) {
    value.clear();
    for (const std::string& key : at.keys()) from_json_value(value[key], at[key], pictures);
  } else {
    value.clear();
    for (const JsonValue& item : at.items()) {
      typename T::value_type one{};
      from_json_value(one, item, pictures);
      value.insert(value.end(), std::move(one));
    }
  }
}

template <class T, class Value>
Field<T> field(std::string key, Value T::*member, std::function<bool(const T&)> there = {}) {
  return {
      std::move(key),
      [member](const T& one, const PictureText& pictures) { return to_json_value(one.*member, pictures); },
      [member](T& one, const JsonValue& at, const PictureText& pictures) {
        from_json_value(one.*member, at, pictures);
      },
      std::move(there)};
}

// Declares a member that is written only if it differs from its default.
template <class T, class Value>
Field<T> field_if_set(std::string key, Value T::*member) {
  return field<T>(std::move(key), member,
                  [member, unset = T{}.*member](const T& one) { return one.*member != unset; });
}

// Declares a member of a member.
template <class T, class Outer, class Value>
Field<T> field(std::string key, Outer T::*outer, Value Outer::*inner) {
  return {
      std::move(key),
      [=](const T& one, const PictureText& pictures) { return to_json_value(one.*outer.*inner, pictures); },
      [=](T& one, const JsonValue& at, const PictureText& pictures) {
        from_json_value(one.*outer.*inner, at, pictures);
      }};
}

// Declares a number that follows from the others: it is written, and compared when it is read.
template <class T>
Field<T> computed(std::string key, double (*get)(const T&)) {
  return {std::move(key), [get](const T& one, const PictureText&) { return get(one); },
          [](T&, const JsonValue& at, const PictureText& pictures) {
            double number = 0;
            from_json_value(number, at, pictures);
          }};
}

// Declares a field that records of earlier versions have. It is skipped and not written.
template <class T>
Field<T> of_earlier_versions(std::string key) {
  return {
      std::move(key), {}, [](T&, const JsonValue&, const PictureText&) {}, [](const T&) { return false; }};
}

// Declares bytes of a PNG file, or of another one that many results may share.
template <class T>
Field<T> picture(std::string key, std::string T::*member) {
  return {std::move(key),
          [member](const T& one, const PictureText& pictures) { return pictures.write(one.*member); },
          [member](T& one, const JsonValue& at, const PictureText& pictures) {
            try {
              one.*member = pictures.read(at.any_text());
            } catch (const std::invalid_argument& error) {
              at.fail(error.what());
            }
          }};
}

// Writes a line for each value, indented by `indent` spaces; -1: all in one line. Ends with a newline.
template <class T>
std::string json_text(const T& value, int indent, const PictureText& pictures = pictures_in_base64()) {
  return to_json_value(value, pictures).dump(indent, ' ', false, OrderedJson::error_handler_t::replace) +
         "\n";
}

// Errors name the text `name`.
template <class T>
T from_json_text(const std::string& text, const std::string& name,
                 const PictureText& pictures = pictures_in_base64()) {
  const nlohmann::json document = hair::parse_json(text, name);
  T value;
  from_json_value(value, JsonValue(document, name), pictures);
  return value;
}

}  // namespace grader::result
