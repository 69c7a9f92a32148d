// The elements of a PLY file, row by row: of any kind, in text or binary. Source: G. Turk, "The PLY Polygon
// File Format" (Stanford, 1994).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

// A type of numbers.
struct PlyType {
  std::string_view name, other_name;  // files use both: "uchar" and "uint8"
  std::size_t size;                   // bytes
  bool whole;
  double least, most;
  double (*value)(std::uint64_t bits);
};

struct PlyProperty {
  std::string name;
  const PlyType* type;
  const PlyType* count_type = nullptr;  // the type of a list's count; null: it is no list
};

struct PlyElement {
  std::string name;
  std::size_t count;
  std::vector<PlyProperty> properties;

  int find(std::string_view property) const;  // its index; -1: there is none, or it is a list
};

enum class PlyFormat { ascii, little_endian, big_endian };

// Reads the header in its constructor, then the rows of all elements in the file's order. All errors are
// BadInput, with the file's name and the line, or in a binary file's body the byte.
class PlyRows {
 public:
  // Also throws for an element without properties, and for elements that are longer than the file, so that it
  // takes no memory for missing rows.
  PlyRows(std::string_view bytes, const std::string& name);

  const std::vector<PlyElement>& elements() const { return elements_; }

  // The next row, of this element: a value for each property, 0 for a list.
  void read(const PlyElement& element, std::vector<double>& row);

  // After the last row: the file ends here, except for white space.
  void expect_end() const;

  [[noreturn]] void fail(const std::string& what) const;       // concerns the whole file
  [[noreturn]] void fail_here(const std::string& what) const;  // concerns the row that was read last

 private:
  std::string_view next_line();
  void read_header();
  void add_element(std::string_view line);
  void add_property(std::string_view line);
  void check_size() const;
  double binary_value(const PlyType& type);
  double ascii_value(std::string_view& line, const std::string& name, const PlyType& type) const;

  std::string_view bytes_;
  std::string name_;
  PlyFormat format_ = PlyFormat::ascii;
  std::vector<PlyElement> elements_;
  bool in_header_ = true;
  std::size_t at_ = 0;      // the next byte
  std::size_t row_at_ = 0;  // the start of the last row, or line
  long line_ = 0;           // the last line that was read, from 1
};

}  // namespace hair
