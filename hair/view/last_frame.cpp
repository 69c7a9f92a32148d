#include <bit>

#include "hair/io/files/json_text.h"
#include "hair/io/plot/base64.h"
#include "hair/view/motion.h"

namespace hair {

namespace {

std::string numbers(const Vector3d& v) {
  return json_list({json_text(v.x()), json_text(v.y()), json_text(v.z())});
}

}  // namespace

std::string MotionFrames::last_json() const {
  std::string bytes;
  bytes.reserve(12 * points_);
  for (std::size_t i = all_.size() - points_; i < all_.size(); ++i)
    for (const float x : all_[i])
      for (int byte = 0; byte < 4; ++byte)
        bytes += static_cast<char>(std::bit_cast<std::uint32_t>(x) >> (8 * byte) & 255U);
  std::string planes;
  for (const Plane& plane : planes_.back())
    planes += (planes.empty() ? "" : ",") +
              json_object({{"points", numbers(plane.point)}, {"normals", numbers(plane.normal)}});
  return json_object({{"data", json_text(base64(bytes))}, {"planes", "[" + planes + "]"}});
}

void MotionFrames::keep_last() {
  all_.erase(all_.begin(), all_.end() - static_cast<std::ptrdiff_t>(points_));
  planes_.erase(planes_.begin(), planes_.end() - 1);
}

}  // namespace hair
