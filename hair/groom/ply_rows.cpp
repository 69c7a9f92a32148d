#include "hair/groom/ply_rows.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "solver/decimal_point.h"

namespace hair {

namespace {

template <class T>
constexpr PlyType type_of(std::string_view name, std::string_view other_name) {
  using Limits = std::numeric_limits<T>;
  return {name,
          other_name,
          sizeof(T),
          Limits::is_integer,
          static_cast<double>(Limits::lowest()),
          static_cast<double>(Limits::max()),
          [](std::uint64_t bits) {
            if constexpr (std::same_as<T, float>)
              return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
            else if constexpr (std::same_as<T, double>)
              return std::bit_cast<double>(bits);
            else
              return static_cast<double>(static_cast<T>(bits));
          }};
}

constexpr PlyType kTypes[] = {
    type_of<std::int8_t>("char", "int8"),    type_of<std::uint8_t>("uchar", "uint8"),
    type_of<std::int16_t>("short", "int16"), type_of<std::uint16_t>("ushort", "uint16"),
    type_of<std::int32_t>("int", "int32"),   type_of<std::uint32_t>("uint", "uint32"),
    type_of<float>("float", "float32"),      type_of<double>("double", "float64")};

// True if the type can store this number of a text.
bool can_be(double value, const PlyType& type) {
  return !type.whole || (value == std::floor(value) && value >= type.least && value <= type.most);
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

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

// The next word without the spaces before it; empty at the line's end.
std::string_view next_word(std::string_view& line) {
  const auto* const begin = std::find_if_not(line.begin(), line.end(), is_space);
  const auto* const end = std::find_if(begin, line.end(), is_space);
  const std::string_view word(begin, static_cast<std::size_t>(end - begin));
  line = std::string_view(end, static_cast<std::size_t>(line.end() - end));
  return word;
}

std::string in_quotes(std::string_view text) {
  return "\"" + printable(text, 40) + "\"";
}

}  // namespace

int PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property && !properties[i].count_type) return static_cast<int>(i);
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
    const PlyType* const found = std::ranges::find_if(
        kTypes, [&](const PlyType& one) { return one.name == name || one.other_name == name; });
    if (found == std::end(kTypes))
      fail_here("there is no type " + in_quotes(name) + "; char, int, float and the like are right");
    return found;
  };
  PlyProperty property;
  std::string_view rest = line;
  if (next_word(rest) == "list") {
    line = rest;
    property.count_type = type();
    if (!property.count_type->whole) fail_here("a list's length is of a whole type");
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
      row +=
          format_ == PlyFormat::ascii ? 2 : (property.count_type ? property.count_type : property.type)->size;
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

double PlyRows::binary_value(const PlyType& type) {
  const std::size_t size = type.size;
  if (bytes_.size() - at_ < size) fail_here("the file ends within this row; it is cut off");
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = format_ == PlyFormat::big_endian ? size - 1 - i : i;
    bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_ + i])) << (8 * place);
  }
  at_ += size;
  return type.value(bits);
}

double PlyRows::ascii_value(std::string_view& line, const std::string& name, const PlyType& type) const {
  const std::string_view word = next_word(line);
  if (word.empty()) fail_here("ends before " + in_quotes(name));
  const std::optional<double> value = number_in(word);
  if (!value || !can_be(*value, type))
    fail_here(in_quotes(word) + " is no number that " + in_quotes(name) + " can be");
  return !type.whole && type.size == sizeof(float) ? static_cast<double>(static_cast<float>(*value)) : *value;
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
    const auto value = [&](const PlyType& type) {
      return ascii ? ascii_value(line, property.name, type) : binary_value(type);
    };
    if (!property.count_type) {
      row[i] = value(*property.type);
      continue;
    }
    const double count = value(*property.count_type);
    if (count < 0) fail_here("a list has a length below 0");
    for (double k = 0; k < count; ++k) value(*property.type);
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
