#include "hair/io/files/strict_json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/read_file.h"

namespace hair {
namespace {

using nlohmann::json;

std::string line_and_column(const std::string& text, std::size_t byte) {
  const std::string_view before(text.data(), std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// The byte at which the parser gives up. Its message for a number out of range lacks this position.
class PlaceOfError : public json::json_sax_t {
 public:
  std::size_t byte = 0;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(json::number_integer_t) override { return true; }
  bool number_unsigned(json::number_unsigned_t) override { return true; }
  bool number_float(json::number_float_t, const json::string_t&) override { return true; }
  bool string(json::string_t&) override { return true; }
  bool binary(json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(json::string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string&, const json::exception&) override {
    byte = position;
    return false;
  }
};

// The library's reason, without its own prefix and position: "syntax error while parsing ...". It quotes the
// text, unshortened and with all of its characters.
std::string reason_of(const json::exception& error) {
  const std::string_view what = error.what();
  const std::size_t syntax = what.find("syntax error");
  const std::size_t prefix = what.find("] ");
  if (syntax == std::string_view::npos)
    return printable(what.substr(prefix == std::string_view::npos ? 0 : prefix + 2));
  const std::string_view reason = what.substr(syntax);
  const std::size_t quoted = std::min(reason.find("last read: "), reason.size());
  const std::size_t after = std::min(reason.rfind("; expected "), reason.size());
  if (after < quoted) return std::string(reason.substr(0, quoted)) + printable(reason.substr(quoted));
  return std::string(reason.substr(0, quoted)) + printable(reason.substr(quoted, after - quoted)) +
         printable(reason.substr(after));
}

}  // namespace

std::string number_range(double lowest, double highest) {
  std::ostringstream range;
  range.imbue(std::locale::classic());
  range.precision(15);
  range << lowest << " to " << highest;
  return range.str();
}

std::string whole_range(long lowest, long highest) {
  return std::to_string(lowest) + " to " + std::to_string(highest);
}

std::string listed(std::span<const std::string_view> words) {
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  return list;
}

json read_json(const std::filesystem::path& file) {
  return parse_json(read_file(file, kMostJsonBytes, "a JSON file"), file.string());
}

json parse_json(const std::string& text, const std::string& file) {
  const std::string name = printable(file, 4096);
  if (const std::size_t zero = text.find('\0'); zero != std::string::npos)  // the library would stop there
    throw BadInput(name + ": " + line_and_column(text, zero + 1) + ": not JSON: a byte 0; remove it");
  std::vector<std::set<std::string>> keys;
  const auto no_key_twice = [&](int depth, json::parse_event_t event, json& parsed) {
    if (depth > kMostJsonDepth)
      throw BadInput(name + ": more than " + std::to_string(kMostJsonDepth) +
                     " lists and objects within each other; nothing here needs as many");
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second) {
      throw BadInput(name + ": \"" + printable(parsed.get<std::string>()) +
                     "\" stands twice in the same object; keep one of them");
    }
    return true;
  };
  try {
    return json::parse(text, no_key_twice, true, true);
  } catch (const json::parse_error& error) {
    throw BadInput(name + ": " + line_and_column(text, error.byte) + ": not JSON: " + reason_of(error));
  } catch (const json::exception& error) {
    PlaceOfError place;
    json::sax_parse(text, &place, json::input_format_t::json, true, true);
    throw BadInput(name + ": " + line_and_column(text, place.byte) + ": not JSON: " + reason_of(error));
  }
}

JsonDocument read_document(const std::filesystem::path& file) {
  return std::make_shared<const json>(read_json(file));
}

JsonDocument parse_document(const std::string& text, const std::string& name) {
  return std::make_shared<const json>(parse_json(text, name));
}

JsonValue::JsonValue(const json& document, std::filesystem::path file)
    : JsonValue(document, std::move(file), "") {}

JsonValue::JsonValue(const json& value, std::filesystem::path file, std::string where)
    : value_(&value), file_(std::move(file)), where_(std::move(where)) {}

void JsonValue::fail(const std::string& what) const {
  throw BadInput(printable(file_.string(), 4096) + ": " + (where_.empty() ? "" : printable(where_) + ": ") +
                 what);
}

std::string JsonValue::shown() const {
  return printable(value_->dump(-1, ' ', true, json::error_handler_t::replace), 60);
}

std::vector<std::string> JsonValue::keys() const {
  if (!value_->is_object()) fail(shown() + " is not an object; write {...}");
  std::vector<std::string> keys;
  for (const auto& item : value_->items()) keys.push_back(item.key());
  return keys;
}

void JsonValue::check_keys(std::initializer_list<std::string_view> required,
                           std::initializer_list<std::string_view> optional) const {
  check_keys(std::span(required.begin(), required.size()), std::span(optional.begin(), optional.size()));
}

void JsonValue::check_keys(std::span<const std::string_view> required,
                           std::span<const std::string_view> optional) const {
  const std::string known =
      listed(required) + (required.size() > 0 && optional.size() > 0 ? ", " : "") + listed(optional);
  for (const std::string& key : keys()) {
    const auto names = [&](std::span<const std::string_view> list) {
      return std::find(list.begin(), list.end(), key) != list.end();
    };
    if (!names(required) && !names(optional)) {
      fail("unknown key \"" + printable(key) + "\"; known here: " + known);
    }
  }
  for (const std::string_view key : required) {
    if (!has(std::string(key))) {
      fail("\"" + std::string(key) + "\" is missing; an object here has: " + known);
    }
  }
}

bool JsonValue::has(const std::string& key) const {
  return value_->contains(key);
}

bool JsonValue::is_null() const {
  return value_->is_null();
}

JsonValue JsonValue::operator[](const std::string& key) const {
  return {value_->at(key), file_, where_ + (where_.empty() ? "" : ".") + key};
}

std::vector<JsonValue> JsonValue::items() const {
  if (!value_->is_array()) fail(shown() + " is not a list; write [...]");
  std::vector<JsonValue> items;
  for (std::size_t i = 0; i < value_->size(); ++i) {
    items.push_back({(*value_)[i], file_, where_ + "[" + std::to_string(i) + "]"});
  }
  return items;
}

std::string JsonValue::text() const {
  const std::string text = any_text();
  if (text.empty()) fail("is empty; write some text");
  // A file's name would end there.
  if (text.find('\0') != std::string::npos) fail(shown() + " has a character U+0000; leave it out");
  return text;
}

std::string JsonValue::any_text() const {
  if (!value_->is_string()) fail(shown() + " is not text; write \"...\"");
  return value_->get<std::string>();
}

std::vector<std::string> JsonValue::texts() const {
  std::vector<std::string> texts;
  for (const JsonValue& item : items()) {
    if (std::find(texts.begin(), texts.end(), item.text()) != texts.end()) {
      item.fail(item.shown() + " stands twice in this list; keep one of them");
    }
    texts.push_back(item.text());
  }
  return texts;
}

long JsonValue::whole_number(long lowest, long highest) const {
  std::optional<long> number;
  if (value_->is_number_float()) {  // 3e2; the parser has already lost digits that a double does not hold
    const auto real = value_->get<double>();
    if (std::floor(real) == real && std::abs(real) < 0x1p53) number = static_cast<long>(real);
  } else if (value_->is_number_integer()) {
    const bool fits =
        !value_->is_number_unsigned() ||
        value_->get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<long>::max());
    if (fits) number = value_->get<std::int64_t>();
  }
  if (!number || *number < lowest || *number > highest)
    fail(shown() + " is not right; give a whole number from " + whole_range(lowest, highest));
  return *number;
}

std::array<double, 3> JsonValue::three_numbers(double lowest, double highest) const {
  if (!value_->is_array() || value_->size() != 3)
    fail(shown() + " is not a list of three numbers, [x, y, z]");
  const std::vector<JsonValue> parts = items();
  return {parts[0].number(lowest, highest), parts[1].number(lowest, highest),
          parts[2].number(lowest, highest)};
}

bool JsonValue::boolean() const {
  if (!value_->is_boolean()) fail(shown() + " is not right; write true or false");
  return value_->get<bool>();
}

std::size_t JsonValue::word(std::initializer_list<std::string_view> words) const {
  return word(std::span(words.begin(), words.size()));
}

std::size_t JsonValue::word(std::span<const std::string_view> words) const {
  if (value_->is_string()) {
    const auto found = std::find(words.begin(), words.end(), value_->get_ref<const std::string&>());
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  }
  fail(shown() + " is not right; write one of: " + listed(words));
}

std::string JsonValue::only_key(std::span<const std::string_view> choices) const {
  const std::vector<std::string> found = keys();
  if (found.size() != 1)
    fail("has " + std::to_string(found.size()) + " keys; give one of: " + listed(choices));
  if (std::find(choices.begin(), choices.end(), found[0]) == choices.end())
    fail("unknown key \"" + printable(found[0]) + "\"; known here: " + listed(choices));
  return found[0];
}

double JsonValue::number(double lowest, double highest) const {
  const double number = value_->is_number() ? value_->get<double>() : lowest;
  if (!value_->is_number() || !(number >= lowest && number <= highest))
    fail(shown() + " is not right; give a number from " + number_range(lowest, highest));
  return number;
}

}  // namespace hair
