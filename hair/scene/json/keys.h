// The keys of a scene's objects. A key is declared once: its name, unit, bounds, default, and a sentence. The
// code that reads an object, its error messages, and the tables of keys follow from the declaration.
//
//   struct Ball {
//     Vector3d centre;
//     double radius = 0.1;
//   };
//   void keys_of(Keys& keys, Ball& ball) {
//     keys.vector("centre", ball.centre, {.unit = "m", .needed = true});
//     keys.number("radius", ball.radius, {.unit = "m", .least = 0, .most = 1}, "its hull");
//   }
//   const Ball ball = read<Ball>(object);
//
// keys_of is called once without an object, to note the keys and the values, which are the defaults. After
// that it is called for each object that is read, and sets the values that the object has.
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hair/io/files/strict_json.h"
#include "particles/vectors.h"

namespace hair::json {

using Eigen::Vector3d;

inline constexpr double kFar = 1e6;      // bounds positions in m, velocities in m/s, accelerations in m/s^2
inline constexpr double kLongest = 1e4;  // m, bounds lengths and radii
inline constexpr double kShortest = 1e-7;
inline constexpr double kLargestSeed = 9007199254740992;  // a double holds all whole numbers up to here

// The shortest text that reads back as the same number.
std::string exact_text(double number);

struct Section;

// An object under a key, or in the list under it. If there are several kinds, each one's heading has an
// addition.
struct ObjectKind {
  const Section& (*section)();
  const char* addition = "";
};

struct KeySpec {
  const char* unit = "";
  bool needed = false;
  double least = -kFar, most = kFar;  // bounds a number, and each number of a vector
  const char* otherwise = nullptr;    // the default in words; null: the value as it is
  std::vector<ObjectKind> objects = {};
};

struct NotedKey {
  const char *name, *what;
  KeySpec spec;
  std::string otherwise, bounds;  // as the tables show them
  bool list = false;              // a list of objects
};

// All keys of an object.
struct Section {
  const char* about = "";
  bool one_of = false;  // an object has exactly one of the keys
  std::vector<NotedKey> keys = {};
  std::vector<std::string_view> needed = {}, optional = {};  // their names

  // Throws BadInput for an object that lacks a key or has another.
  void check(const JsonValue& object) const;
};

template <class T>
const Section& section_of();
template <class T>
T read(const JsonValue& object);

template <class T>
constexpr ObjectKind object(const char* addition = "") {
  return {section_of<T>, addition};
}

class Keys {
 public:
  explicit Keys(Section& noted) : noted_(&noted) {}
  explicit Keys(const JsonValue& object) : object_(&object) {}

  void about(const char* text) {
    if (noted_) noted_->about = text;
  }
  void one_of() {
    if (noted_) noted_->one_of = true;
  }

  // The named type is that of the value, or of its std::optional. Without the key the value stays as it is.
  template <class Value>  // double
  void number(const char* key, Value& value, const KeySpec& spec = {}, const char* what = "") {
    if (has(key, value, spec, what, [&] { return number_range(spec.least, spec.most); }))
      value = at(key).number(spec.least, spec.most);
  }
  template <class Value>  // double, a length in metres
  void length(const char* key, Value& value, KeySpec spec = {}, const char* what = "") {
    spec.unit = "m";
    spec.least = kShortest;
    spec.most = kLongest;
    number(key, value, spec, what);
  }
  template <class Value>  // a whole number
  void whole(const char* key, Value& value, const KeySpec& spec = {}, const char* what = "") {
    const auto least = static_cast<long>(spec.least), most = static_cast<long>(spec.most);
    if (has(key, value, spec, what, [&] { return "whole, " + whole_range(least, most); }))
      value = static_cast<Plain<Value>>(at(key).whole_number(least, most));
  }
  template <class Value>  // Vector3d
  void vector(const char* key, Value& value, const KeySpec& spec = {}, const char* what = "") {
    if (has(key, value, spec, what, [&] { return number_range(spec.least, spec.most); }))
      value = vector_at(key, spec);
  }
  template <class Value>  // Vector3d, of any length but 0, which becomes 1
  void direction(const char* key, Value& value, const KeySpec& spec = {}, const char* what = "") {
    if (has(key, value, spec, what, [&] { return number_range(spec.least, spec.most); }))
      value = direction_at(key, spec);
  }
  template <class Value>  // bool
  void flag(const char* key, Value& value, const KeySpec& spec = {}, const char* what = "") {
    if (has(key, value, spec, what, [] { return "true, false"; })) value = at(key).boolean();
  }
  template <class Value>  // std::string
  void text(const char* key, Value& value, const KeySpec& spec = {}, const char* what = "") {
    if (has(key, value, spec, what)) value = at(key).text();
  }
  template <class Value>  // one of the words: its index, as an enumeration, a number or a bool
  void word(const char* key, Value& value, const std::vector<std::string_view>& words,
            const KeySpec& spec = {}, const char* what = "") {
    if (has(key, Word{words, index_of(value)}, spec, what, [&] { return listed(words); }))
      value = static_cast<Plain<Value>>(at(key).word(words));
  }
  template <class Value>  // an object of a type that has keys_of
  void part(const char* key, Value& value, KeySpec spec = {}, const char* what = "") {
    spec.objects = {object<Plain<Value>>()};
    if (has(key, Nothing{}, spec, what)) value = read<Plain<Value>>(at(key));
  }
  // The caller reads the value: an object of the spec's kinds, a list of such objects, or anything else.
  void any(const char* key, std::optional<JsonValue>& value, const KeySpec& spec = {},
           const char* what = "") {
    if (has(key, Nothing{}, spec, what)) value = at(key);
  }
  void list(const char* key, std::optional<JsonValue>& value, const KeySpec& spec, const char* what = "") {
    if (has(key, Nothing{}, spec, what, no_bounds, true)) value = at(key);
  }

 private:
  template <class T>
  struct PlainType {
    using Type = T;
  };
  template <class T>
  struct PlainType<std::optional<T>> {
    using Type = T;
  };
  template <class T>
  using Plain = typename PlainType<T>::Type;

  struct Nothing {};
  struct Word {
    const std::vector<std::string_view>& words;
    std::size_t index;
  };

  // True if there is an object that has the key. Without an object, notes the key.
  template <class Value, class Bounds = std::string (*)()>
  bool has(const char* key, const Value& value, const KeySpec& spec, const char* what,
           const Bounds& bounds = no_bounds, bool list = false) {
    if (object_) return object_->has(key);
    note({key, what, spec,
          spec.needed      ? "needed"
          : spec.otherwise ? spec.otherwise
                           : text_of(value),
          bounds(), list});
    return false;
  }
  static std::string no_bounds() { return ""; }
  void note(NotedKey key);
  JsonValue at(const char* key) const { return (*object_)[key]; }
  Vector3d vector_at(const char* key, const KeySpec& spec) const;
  Vector3d direction_at(const char* key, const KeySpec& spec) const;

  template <class Value>
  static std::size_t index_of(const Value& value) {
    return static_cast<std::size_t>(value);
  }
  template <class Value>
  static std::size_t index_of(const std::optional<Value>&) {
    return 0;
  }
  static std::string text_of(double number) { return exact_text(number); }
  static std::string text_of(const Vector3d& vector);
  static std::string text_of(bool flag) { return flag ? "true" : "false"; }
  static std::string text_of(const std::string& text) { return text; }
  static std::string text_of(const Word& word) { return std::string(word.words[word.index]); }
  static std::string text_of(Nothing) { return ""; }
  template <class Value>
  static std::string text_of(const std::optional<Value>& value) {
    return value ? text_of(*value) : "";
  }
  template <std::integral Value>
  static std::string text_of(Value value) {
    return std::to_string(value);
  }

  Section* noted_ = nullptr;
  const JsonValue* object_ = nullptr;
};

// The words of a key: this text of each row of a table.
template <class Rows, class Row, class Text>
std::vector<std::string_view> words_of(const Rows& rows, Text Row::*text) {
  std::vector<std::string_view> words;
  for (const Row& row : rows) words.emplace_back(row.*text);
  return words;
}

template <class T>
const Section& section_of() {
  static const Section section = [] {
    Section noted;
    Keys keys(noted);
    T value{};
    keys_of(keys, value);
    return noted;
  }();
  return section;
}

template <class T>
T read(const JsonValue& object) {
  section_of<T>().check(object);
  T value{};
  Keys keys(object);
  keys_of(keys, value);
  return value;
}

// Markdown: a section for the object, with the name, unit, default, bounds and meaning of its keys, and one
// for each object in it. Headings are paths: "hair[].roots"; `top` is the path of the object itself.
std::string key_tables(const ObjectKind& object, const std::string& top);

}  // namespace hair::json
