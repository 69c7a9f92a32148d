#include "hair/head/data_file.h"

#include "hair/head/groom_bytes.h"

namespace hair {

Groom parse_data_file(std::string_view bytes, const std::string& name, Numbers numbers) {
  const GroomBytes file(bytes, name, numbers);
  if (file.size() < 4) file.fail("is not a .data file, which begins with the number of its strands, 4 bytes");
  const std::uint32_t strands = file.number(0);
  // A bald root has 16 bytes.
  const std::size_t most = (file.size() - 4) / 16;
  if (strands == 0 || strands > most)
    file.fail_at(0, "says that there are " + std::to_string(static_cast<std::int32_t>(strands)) +
                        " strands; a file of " + std::to_string(file.size()) + " bytes has " +
                        (most == 0 ? "none" : "1 to " + std::to_string(most)));
  Groom groom;
  groom.strands.reserve(strands);
  std::size_t at = 4, points = 0;
  for (std::size_t i = 0; i < strands; ++i) {
    const std::string which = "strand " + std::to_string(i);
    if (file.size() - at < 4)
      file.fail_at(at,
                   "the file ends before " + which + " of " + std::to_string(strands) + "; it is cut off");
    const std::uint32_t count = file.number(at);
    const std::size_t room = (file.size() - at - 4) / 12;
    if (count == 0 || count > room)
      file.fail_at(at, which + " says that it has " + std::to_string(static_cast<std::int32_t>(count)) +
                           " points; the bytes after it hold " + std::to_string(room) +
                           ", and a strand has one at least");
    points += count;
    if (points > kMostGroomPoints)
      file.fail_at(at, "with " + which + " there are more than " + std::to_string(kMostGroomPoints) +
                           " points; no more are read");
    groom.strands.push_back(file.points(at + 4, count, i));
    at += 4 + 12 * static_cast<std::size_t>(count);
  }
  if (at != file.size())
    file.fail_at(at, "has " + std::to_string(file.size() - at) +
                         " bytes after its last strand; a .data file ends there");
  return groom;
}

std::string data_file_of(const Groom& groom) {
  check_writable(groom, 1);
  std::string bytes;
  put_number(bytes, static_cast<std::uint32_t>(groom.strands.size()));
  for (const Eigen::VectorXd& x : groom.strands) {
    put_number(bytes, static_cast<std::uint32_t>(points_of(x)));
    for (const double number : x) put_real(bytes, static_cast<float>(number));
  }
  return bytes;
}

}  // namespace hair
