#include "hair/head/hair_file.h"

#include <bit>
#include <cstdint>
#include <limits>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/read_file.h"

namespace hair {

namespace {

constexpr std::size_t kHeader = 128;
enum Array : std::uint32_t {
  segments = 1,
  points = 2,
  thickness = 4,
  transparency = 8,
  colours = 16,
  all = 31
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(printable(name, 4096)) {}

  [[noreturn]] void fail(const std::string& what) const { throw BadInput(name_ + ": " + what); }

  // An unsigned number of `size` bytes, `at` bytes from the start. The caller knows that they are there.
  std::uint32_t number(std::size_t at, int size) const {
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i)
      value |=
          static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[at + static_cast<std::size_t>(i)]))
          << (8 * i);
    return value;
  }
  float real(std::size_t at) const { return std::bit_cast<float>(number(at, 4)); }
  std::size_t size() const { return bytes_.size(); }
  bool begins_with(std::string_view start) const { return bytes_.substr(0, start.size()) == start; }

 private:
  std::string_view bytes_;
  std::string name_;
};

struct Header {
  std::uint32_t strands, points, arrays, segments;
};

// The header, of a file that is as long as it says.
Header read_header(const Reader& reader) {
  if (reader.size() < kHeader || !reader.begins_with("HAIR"))
    reader.fail("is not a .hair file, which begins with \"HAIR\" and a header of 128 bytes");
  const Header header{reader.number(4, 4), reader.number(8, 4), reader.number(12, 4), reader.number(16, 4)};
  if ((header.arrays & ~static_cast<std::uint32_t>(Array::all)) != 0)
    reader.fail("has arrays that a .hair file does not (" + std::to_string(header.arrays) +
                "; the sum of 1, 2, 4, 8 and 16 is right)");
  if ((header.arrays & Array::points) == 0) reader.fail("has no points; a groom is made of them");
  if (header.strands == 0) reader.fail("has no strands; a groom has one at least");
  if (header.points > kMostGroomPoints)
    reader.fail("has " + std::to_string(header.points) + " points; at most " +
                std::to_string(kMostGroomPoints) + " are read");
  std::uint64_t expected = kHeader, n = header.points;
  if (header.arrays & Array::segments) expected += 2 * static_cast<std::uint64_t>(header.strands);
  if (header.arrays & Array::points) expected += 12 * n;
  if (header.arrays & Array::thickness) expected += 4 * n;
  if (header.arrays & Array::transparency) expected += 4 * n;
  if (header.arrays & Array::colours) expected += 12 * n;
  if (expected != reader.size())
    reader.fail("has " + std::to_string(reader.size()) + " bytes, and its header says " +
                std::to_string(expected) + "; it is cut off or damaged");
  return header;
}

// How many points each strand has: together all that there are.
std::vector<std::uint32_t> read_counts(const Reader& reader, const Header& header) {
  const bool own = (header.arrays & Array::segments) != 0;
  // A strand has two points at the least, so that this bounds what there is to allocate.
  if (header.strands > header.points / 2)
    reader.fail("has " + std::to_string(header.strands) + " strands and " + std::to_string(header.points) +
                " points; a strand has two at least");
  std::vector<std::uint32_t> counts(header.strands);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::uint64_t segments = own ? reader.number(kHeader + 2 * i, 2) : header.segments;
    if (segments == 0)
      reader.fail("strand " + std::to_string(i) + " is a single point; a strand has two at least");
    sum += segments + 1;
    if (sum > header.points) break;
    counts[i] = static_cast<std::uint32_t>(segments + 1);
  }
  if (sum != header.points)
    reader.fail("its strands do not have the " + std::to_string(header.points) +
                " points that its header says; it is damaged");
  return counts;
}

}  // namespace

Groom parse_hair_file(std::string_view bytes, const std::string& name) {
  const Reader reader(bytes, name);
  const Header header = read_header(reader);
  const std::vector<std::uint32_t> counts = read_counts(reader, header);
  std::size_t at = kHeader + ((header.arrays & Array::segments) ? 2 * counts.size() : 0);
  Groom groom;
  groom.strands.reserve(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    Eigen::VectorXd& x = groom.strands.emplace_back(3 * static_cast<Eigen::Index>(counts[i]));
    for (Eigen::Index k = 0; k < x.size(); ++k, at += 4) x[k] = static_cast<double>(reader.real(at));
    const auto place = [&](Eigen::Index point) {
      return "strand " + std::to_string(i) + ", point " + std::to_string(point) + ": ";
    };
    for (Eigen::Index k = 0; k < x.size(); ++k)
      if (!(std::abs(x[k]) <= std::numeric_limits<float>::max()))
        reader.fail(place(k / 3) + "has a number that is not finite");
    for (Eigen::Index k = 3; k < x.size(); k += 3)
      if (x.segment<3>(k) == x.segment<3>(k - 3))
        reader.fail(place(k / 3) + "is where the point before it is; a segment has a length");
  }
  return groom;
}

Groom read_hair_file(const std::filesystem::path& file) {
  return parse_hair_file(read_file(file, kMostGroomBytes, "a .hair file"), file.string());
}

}  // namespace hair
