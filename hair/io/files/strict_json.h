// JSON files that people write: read strictly, so that a slip of the pen is reported and not
// passed over. The library's own header, which takes seconds to compile, is for those who look into a document without
// JsonValue.
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

// A file's JSON. Throws BadInput with file, line and column; a key that stands twice in an object is an
// error, too, and so is a file of more than kMostJsonBytes or a value within more than kMostJsonDepth others.
nlohmann::json read_json(const std::filesystem::path& file);

// The same of text that is at hand; `name` stands for the file in what is thrown.
nlohmann::json parse_json(const std::string& text, const std::string& name);

// The same for those who look into them through JsonValue alone.
using JsonDocument = std::shared_ptr<const nlohmann::json>;
JsonDocument read_document(const std::filesystem::path& file);
JsonDocument parse_document(const std::string& text, const std::string& name);

// A value and where it stands. Every check that fails throws BadInput: "FILE: exercises[0].points: what is
// wrong; what would be right". The document must outlive it.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& document, std::filesystem::path file);

  // An object that has all of `required` and nothing beside them and `optional`.
  void check_keys(std::initializer_list<std::string_view> required,
                  std::initializer_list<std::string_view> optional = {}) const;
  bool has(const std::string& key) const;
  JsonValue operator[](const std::string& key) const;  // of an object, a key that it has
  bool is_null() const;

  std::vector<std::string> keys() const;   // of an object
  std::vector<JsonValue> items() const;    // of an array
  std::string text() const;                // a string that is not empty
  std::vector<std::string> texts() const;  // an array of such strings, no two of them equal
  double number(double lowest, double highest) const;
  long whole_number(long lowest, long highest) const;                        // also written as 3.0 or 3e2
  std::array<double, 3> three_numbers(double lowest, double highest) const;  // an array of them
  bool boolean() const;
  std::size_t word(std::initializer_list<std::string_view> words) const;  // one of them: which
  std::size_t word(std::span<const std::string_view> words) const;
  // An object's only key, one of `choices`.
  std::string only_key(std::initializer_list<std::string_view> choices) const;

  [[noreturn]] void fail(const std::string& what) const;

 private:
  JsonValue(const nlohmann::json& value, std::filesystem::path file, std::string where);
  std::string shown() const;

  const nlohmann::json* value_;
  std::filesystem::path file_;
  std::string where_;
};

}  // namespace hair
