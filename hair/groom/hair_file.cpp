#include "hair/groom/hair_file.h"

#include <algorithm>
#include <limits>

#include "hair/groom/groom_bytes.h"
#include "hair/io/files/bad_input.h"

namespace hair {

namespace {

constexpr std::size_t kHeader = 128, kInfo = 40;
// The bits of the arrays. Those of the look have the bits after these, in the order of parts_of.
struct Array {
  enum : std::uint32_t { segments = 1, points = 2, thickness = 4, all = 31 };
};

struct Header {
  std::uint32_t strands, points, arrays, segments;
};

// The header of a file whose length agrees with it.
Header read_header(const GroomBytes& file) {
  if (file.size() < kHeader || !file.begins_with("HAIR"))
    file.fail("is not a .hair file, which begins with \"HAIR\" and a header of 128 bytes");
  const Header header{file.number(4), file.number(8), file.number(12), file.number(16)};
  if ((header.arrays & ~static_cast<std::uint32_t>(Array::all)) != 0)
    file.fail_at(12, "names arrays that a .hair file does not have (" + std::to_string(header.arrays) +
                         "; the sum of 1, 2, 4, 8 and 16 is right)");
  if ((header.arrays & Array::points) == 0)
    file.fail_at(12, "says that there are no points; a groom is made of them");
  if (header.strands == 0) file.fail_at(4, "says that there are no strands; a groom has one at least");
  if (header.points > kMostGroomPoints)
    file.fail_at(8, "says that there are " + std::to_string(header.points) + " points; at most " +
                        std::to_string(kMostGroomPoints) + " are read");
  std::uint64_t expected = kHeader, n = header.points;
  if (header.arrays & Array::segments) expected += 2 * static_cast<std::uint64_t>(header.strands);
  if (header.arrays & Array::points) expected += 12 * n;
  for (std::size_t k = 0; k < 3; ++k)
    if (header.arrays & Array::thickness << k) expected += 4 * parts_of({})[k].size * n;
  if (expected != file.size())
    file.fail("has " + std::to_string(file.size()) + " bytes, and its header says " +
              std::to_string(expected) + "; it is cut off or damaged");
  return header;
}

// The number of points of each strand; their sum is the header's.
std::vector<std::uint32_t> read_counts(const GroomBytes& file, const Header& header) {
  const bool own = (header.arrays & Array::segments) != 0;
  // A strand has at least one point, so this bounds the memory to allocate.
  if (header.strands > header.points)
    file.fail_at(4, "says that there are " + std::to_string(header.strands) + " strands and " +
                        std::to_string(header.points) + " points; a strand has one at least");
  std::vector<std::uint32_t> counts(header.strands);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::size_t place = own ? kHeader + 2 * i : 16;
    const std::uint64_t segments = own ? file.number(place, 2) : header.segments;
    sum += segments + 1;
    if (sum > header.points) break;
    counts[i] = static_cast<std::uint32_t>(segments + 1);
  }
  if (sum != header.points)
    file.fail_at(8, "says that there are " + std::to_string(header.points) +
                        " points, and its strands do not have so many; it is damaged");
  return counts;
}

GroomLook read_look(const GroomBytes& file, const Header& header, std::size_t at) {
  GroomLook look;
  const float thickness = file.real(20, "the thickness");
  if (file.number(20) != 0) look.thickness = thickness;
  look.transparency = file.real(24, "the transparency");
  look.colour.emplace();
  for (std::size_t k = 0; k < 3; ++k) (*look.colour)[k] = file.real(28 + 4 * k, "the colour");
  const std::string_view info = file.part(kInfo, look.info.size());
  std::copy(info.begin(), info.end(), look.info.begin());
  look.own_segments = (header.arrays & Array::segments) != 0;
  if (look.own_segments) look.segments = header.segments;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(header.arrays & Array::thickness << k)) continue;
    const LookPart part = parts_of(look)[k];
    std::vector<float>& numbers = *numbers_of_points(look)[k];
    numbers.resize(part.size * header.points);
    for (float& number : numbers) {
      number = file.real(at, "the points' " + std::string(part.name));
      at += 4;
    }
  }
  return look;
}

void put_reals(std::string& bytes, const auto& numbers) {
  for (const float number : numbers) put_real(bytes, number);
}

}  // namespace

Groom parse_hair_file(std::string_view bytes, const std::string& name, Numbers numbers) {
  const GroomBytes file(bytes, name, numbers);
  const Header header = read_header(file);
  const std::vector<std::uint32_t> counts = read_counts(file, header);
  std::size_t at = kHeader + ((header.arrays & Array::segments) ? 2 * counts.size() : 0);
  Groom groom;
  groom.strands.reserve(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    groom.strands.push_back(file.points(at, counts[i], i));
    at += 12 * static_cast<std::size_t>(counts[i]);
  }
  groom.look = read_look(file, header, at);
  return groom;
}

std::string hair_file_of(const Groom& groom) {
  check_writable(groom);
  const GroomLook& look = groom.look;
  const auto segments_of = [](const Eigen::VectorXd& x) {
    return static_cast<std::uint32_t>(points_of(x) - 1);
  };
  const std::uint32_t first = segments_of(groom.strands.front());
  const bool same = std::all_of(groom.strands.begin(), groom.strands.end(),
                                [&](const Eigen::VectorXd& x) { return segments_of(x) == first; });
  constexpr std::uint32_t most = std::numeric_limits<std::uint16_t>::max();
  const bool own = !same || (look.own_segments && first <= most);
  if (own)
    for (std::size_t i = 0; i < groom.strands.size(); ++i)
      if (segments_of(groom.strands[i]) > most)
        throw BadInput("strand " + std::to_string(i) + " of the groom: has " +
                       std::to_string(segments_of(groom.strands[i])) +
                       " segments; in a .hair file it has at most 65535");

  std::uint32_t arrays = Array::points;
  if (own) arrays |= Array::segments;
  for (std::size_t k = 0; k < 3; ++k)
    if (!parts_of(look)[k].of_each.empty()) arrays |= Array::thickness << k;
  std::string bytes = "HAIR";
  put_number(bytes, static_cast<std::uint32_t>(groom.strands.size()));
  put_number(bytes, static_cast<std::uint32_t>(points_of(groom)));
  put_number(bytes, arrays);
  put_number(bytes, own ? look.segments : first);
  put_real(bytes, look.thickness.value_or(0));
  put_real(bytes, look.transparency.value_or(0));
  put_reals(bytes, look.colour.value_or(std::array<float, 3>{1, 1, 1}));
  bytes.append(look.info.begin(), look.info.end());
  if (own)
    for (const Eigen::VectorXd& x : groom.strands) put_number(bytes, segments_of(x), 2);
  for (const Eigen::VectorXd& x : groom.strands)
    for (const double number : x) put_real(bytes, static_cast<float>(number));
  for (const LookPart& part : parts_of(look)) put_reals(bytes, part.of_each);
  return bytes;
}

}  // namespace hair
