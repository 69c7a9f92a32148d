// Reads JSON files that people write. It is strict, so that mistakes are reported. The JSON library's own
// header takes seconds to compile; only code that does not use JsonValue needs it.
#pragma once

#include <array>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

inline constexpr std::size_t kMostJsonBytes = 64 << 20;
inline constexpr int kMostJsonDepth = 64;

// A file's JSON, with comments as in C++. Throws BadInput with file, line and column. Errors are also: the
// same key twice in an object, a byte 0, a file of more than kMostJsonBytes, and a value nested deeper than
// kMostJsonDepth.
nlohmann::json read_json(const std::filesystem::path& file);

// The same for a text; errors name it `name`.
nlohmann::json parse_json(const std::string& text, const std::string& name);

// The same for code that uses only JsonValue.
using JsonDocument = std::shared_ptr<const nlohmann::json>;
JsonDocument read_document(const std::filesystem::path& file);
JsonDocument parse_document(const std::string& text, const std::string& name);

// Bounds as errors show them: "0 to 0.9", "1 to 1000"; and words, "none, band".
std::string number_range(double lowest, double highest);
std::string whole_range(long lowest, long highest);
std::string listed(std::span<const std::string_view> words);

// A value and its position. Every failed check throws BadInput: "FILE: exercises[0].points: what is
// wrong; what would be right". The document must outlive the JsonValue.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& document, std::filesystem::path file);

  // Checks an object: it has all keys of `required`, and no others except those of `optional`.
  void check_keys(std::initializer_list<std::string_view> required,
                  std::initializer_list<std::string_view> optional = {}) const;
  void check_keys(std::span<const std::string_view> required,
                  std::span<const std::string_view> optional) const;
  bool has(const std::string& key) const;
  JsonValue operator[](const std::string& key) const;  // the value of an object's key, which must be there
  bool is_null() const;

  std::vector<std::string> keys() const;   // the keys of an object
  std::vector<JsonValue> items() const;    // the items of an array
  std::string text() const;                // a non-empty string without U+0000
  std::string any_text() const;            // a string
  std::vector<std::string> texts() const;  // an array of such strings, all different
  double number(double lowest, double highest) const;
  // Also accepts 3.0 or 3e2, below 2^53: a larger number in this form may differ from the written one.
  long whole_number(long lowest, long highest) const;
  std::array<double, 3> three_numbers(double lowest, double highest) const;  // an array of three
  bool boolean() const;
  std::size_t word(std::initializer_list<std::string_view> words) const;  // the index of the value in `words`
  std::size_t word(std::span<const std::string_view> words) const;
  // The only key of an object; it must be one of `choices`.
  std::string only_key(std::span<const std::string_view> choices) const;

  const nlohmann::json& value() const { return *value_; }
  std::string shown() const;  // the value in a message: printable, and cut
  [[noreturn]] void fail(const std::string& what) const;

 private:
  JsonValue(const nlohmann::json& value, std::filesystem::path file, std::string where);

  const nlohmann::json* value_;
  std::filesystem::path file_;
  std::string where_;
};

}  // namespace hair
