#include "hair/groom/ply_rows.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "solver/decimal_point.h"

namespace hair {

namespace {

// Files use both sets of names.
constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes = {{{"char", PlyType::i8},
                                                                          {"uchar", PlyType::u8},
                                                                          {"short", PlyType::i16},
                                                                          {"ushort", PlyType::u16},
                                                                          {"int", PlyType::i32},
                                                                          {"uint", PlyType::u32},
                                                                          {"float", PlyType::f32},
                                                                          {"double", PlyType::f64},
                                                                          {"int8", PlyType::i8},
                                                                          {"uint8", PlyType::u8},
                                                                          {"int16", PlyType::i16},
                                                                          {"uint16", PlyType::u16},
                                                                          {"int32", PlyType::i32},
                                                                          {"uint32", PlyType::u32},
                                                                          {"float32", PlyType::f32},
                                                                          {"float64", PlyType::f64}}};

std::optional<PlyType> type_named(std::string_view name) {
  const auto* const found =
      std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& one) { return one.first == name; });
  return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool is_whole(PlyType type) {
  return type != PlyType::f32 && type != PlyType::f64;
}

// True if the type can store this number of a text.
bool can_be(double value, PlyType type) {
  if (!is_whole(type)) return true;
  const bool has_sign = type == PlyType::i8 || type == PlyType::i16 || type == PlyType::i32;
  const double values = std::ldexp(1.0, static_cast<int>(8 * size_of(type)));
  const double low = has_sign ? -values / 2 : 0;
  return value == std::floor(value) && value >= low && value < low + values;
}

// The word as a number; none if it contains anything else, or if a double can't hold it. Not every standard
// library has std::from_chars for double.
std::optional<double> number_in(std::string_view word) {
  // strtod also takes a plus and hexadecimal digits.
  if (word.empty() || word.front() == '+' || word.find_first_of("xX") != std::string_view::npos) return {};
  const std::string text(word);
  const solver::DecimalPoint point;
  char* end = nullptr;
  errno = 0;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size() || (errno == ERANGE && (std::isinf(value) || value == 0))) return {};
  return value;
}

double value_of(std::uint64_t bits, PlyType type) {
  switch (type) {
    case PlyType::i8:
      return static_cast<double>(static_cast<std::int8_t>(bits));
    case PlyType::i16:
      return static_cast<double>(static_cast<std::int16_t>(bits));
    case PlyType::i32:
      return static_cast<double>(static_cast<std::int32_t>(bits));
    case PlyType::f32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case PlyType::f64:
      return std::bit_cast<double>(bits);
    default:
      return static_cast<double>(bits);
  }
}

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

std::string in_quotes(std::string_view text) {
  return "\"" + printable(text, 40) + "\"";
}

}  // namespace

int PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property && !properties[i].list) return static_cast<int>(i);
  return -1;
}

PlyRows::PlyRows(std::string_view bytes, const std::string& name)
    : bytes_(bytes), name_(printable(name, 4096)) {
  read_header();
  check_size();
  in_header_ = false;
}

void PlyRows::fail(const std::string& what) const {
  throw BadInput(name_ + ": " + what);
}

void PlyRows::fail_here(const std::string& what) const {
  const bool text = in_header_ || format_ == PlyFormat::ascii;
  fail(text ? "line " + std::to_string(line_) + ": " + what
            : "byte " + std::to_string(row_at_) + ": " + what);
}

std::string_view PlyRows::next_line() {
  ++line_;
  row_at_ = at_;
  if (at_ == bytes_.size()) fail_here("the file ends here; it is cut off");
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  const std::string_view line = bytes_.substr(at_, end - at_);
  at_ = std::min(end + 1, bytes_.size());
  return line;
}

// The next word without the spaces before it; empty at the line's end.
std::string_view PlyRows::next_word(std::string_view& line) const {
  const auto* const begin = std::find_if_not(line.begin(), line.end(), is_space);
  const auto* const end = std::find_if(begin, line.end(), is_space);
  const std::string_view word(begin, static_cast<std::size_t>(end - begin));
  line = std::string_view(end, static_cast<std::size_t>(line.end() - end));
  return word;
}

void PlyRows::read_header() {
  if (bytes_.substr(0, 3) != "ply" || bytes_.size() < 4 || !is_space(bytes_[3]))
    fail("is not a PLY file, which begins with a line \"ply\"");
  next_line();
  bool has_format = false;
  while (true) {
    std::string_view line = next_line();
    const std::string_view word = next_word(line);
    if (word == "end_header") break;
    if (word == "comment" || word == "obj_info") continue;
    if (word == "format") {
      const std::string_view format = next_word(line), version = next_word(line);
      format_ = format == "ascii"                  ? PlyFormat::ascii
                : format == "binary_little_endian" ? PlyFormat::little_endian
                                                   : PlyFormat::big_endian;
      if ((format_ == PlyFormat::big_endian && format != "binary_big_endian") || version != "1.0")
        fail_here("has the format " + in_quotes(format) + " " + in_quotes(version) +
                  "; ascii, binary_little_endian and binary_big_endian 1.0 are read");
      has_format = true;
    } else if (word == "element") {
      add_element(line);
    } else if (word == "property") {
      add_property(line);
    } else {
      fail_here("begins with " + in_quotes(word) +
                "; a header has format, comment, obj_info, element, property and end_header");
    }
  }
  if (!has_format) fail_here("the header has no format");
}

void PlyRows::add_element(std::string_view line) {
  const std::string_view name = next_word(line), number = next_word(line);
  std::uint64_t count = 0;
  const char* const last = number.data() + number.size();
  const auto [end, error] = std::from_chars(number.data(), last, count);
  if (number.empty() || error != std::errc() || end != last)
    fail_here("the element " + in_quotes(name) + " has the count " + in_quotes(number) +
              "; a whole number is right");
  elements_.push_back({std::string(name), count, {}});
}

void PlyRows::add_property(std::string_view line) {
  if (elements_.empty()) fail_here("a property comes before the first element");
  const auto type = [&] {
    const std::string_view name = next_word(line);
    const std::optional<PlyType> found = type_named(name);
    if (!found)
      fail_here("there is no type " + in_quotes(name) + "; char, int, float and the like are right");
    return *found;
  };
  PlyProperty property;
  std::string_view rest = line;
  if (next_word(rest) == "list") {
    line = rest;
    property.list = true;
    property.count_type = type();
    if (!is_whole(property.count_type)) fail_here("a list's length is of a whole type");
  }
  property.type = type();
  property.name = std::string(next_word(line));
  elements_.back().properties.push_back(std::move(property));
}

void PlyRows::check_size() const {
  const std::size_t room = bytes_.size() - at_;
  std::size_t needed = 0;
  for (const PlyElement& element : elements_) {
    std::size_t row = 0;
    for (const PlyProperty& property : element.properties)
      // A text has at least a digit and a space.
      row += format_ == PlyFormat::ascii ? 2 : size_of(property.list ? property.count_type : property.type);
    if (row == 0) fail("the element " + in_quotes(element.name) + " has no properties; leave it out");
    // The last line may end without a line's end.
    if (element.count > (room + 1 - needed) / row)
      fail("its header says that there are " + std::to_string(element.count) + " of " +
           in_quotes(element.name) + "; the " + std::to_string(room) +
           " bytes after it are too few, and the file is cut off or damaged");
    needed += element.count * row;
    if (needed > room + 1) fail("is cut off or damaged: its header says more than the file holds");
  }
}

double PlyRows::binary_value(PlyType type) {
  const std::size_t size = size_of(type);
  if (bytes_.size() - at_ < size) fail_here("the file ends within this row; it is cut off");
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = format_ == PlyFormat::big_endian ? size - 1 - i : i;
    bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_ + i])) << (8 * place);
  }
  at_ += size;
  return value_of(bits, type);
}

double PlyRows::ascii_value(std::string_view& line, const std::string& name, PlyType type) const {
  const std::string_view word = next_word(line);
  if (word.empty()) fail_here("ends before " + in_quotes(name));
  const std::optional<double> value = number_in(word);
  if (!value || !can_be(*value, type))
    fail_here(in_quotes(word) + " is no number that " + in_quotes(name) + " can be");
  return type == PlyType::f32 ? static_cast<double>(static_cast<float>(*value)) : *value;
}

void PlyRows::read(const PlyElement& element, std::vector<double>& row) {
  row.assign(element.properties.size(), 0);
  const bool ascii = format_ == PlyFormat::ascii;
  std::string_view line;
  if (ascii) {
    line = next_line();
  } else {
    row_at_ = at_;
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    const auto value = [&](PlyType type) {
      return ascii ? ascii_value(line, property.name, type) : binary_value(type);
    };
    if (!property.list) {
      row[i] = value(property.type);
      continue;
    }
    const double count = value(property.count_type);
    if (count < 0) fail_here("a list has a length below 0");
    for (double k = 0; k < count; ++k) value(property.type);
  }
  if (ascii && !next_word(line).empty())
    fail_here("has more numbers than the " + std::to_string(row.size()) + " properties of " +
              in_quotes(element.name));
}

void PlyRows::expect_end() const {
  const std::string_view rest = bytes_.substr(at_);
  const bool text = format_ == PlyFormat::ascii;
  const bool ends = text ? std::all_of(rest.begin(), rest.end(), is_space) : rest.empty();
  if (!ends)
    fail((text ? "line " + std::to_string(line_ + 1) : "byte " + std::to_string(at_)) +
         ": there is more after the last element; a PLY file ends there");
}

}  // namespace hair
