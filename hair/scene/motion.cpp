#include "hair/scene/motion.h"

#include <algorithm>
#include <cstddef>

namespace hair {

Pose Motion::at(double time) const {
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), time, [](double t, const Key& key) { return t < key.time; });
  if (after == keys.begin()) return keys.front().pose;
  if (after == keys.end()) return keys.back().pose;
  const Key &from = *(after - 1), &to = *after;
  const double s = (time - from.time) / (to.time - from.time), way = s * s * (3 - 2 * s);
  return {from.pose.position + way * (to.pose.position - from.pose.position),
          from.pose.rotation.slerp(way, to.pose.rotation).normalized()};
}

Way way_at(const Motion& motion, double time) {
  const Pose now = motion.at(time), first = motion.keys.front().pose;
  return {now.rotation * first.rotation.conjugate(), first.position, now.position};
}

bool turns(const Motion& motion) {
  for (const Key& key : motion.keys)
    if (key.pose.rotation.angularDistance(motion.keys.front().pose.rotation) != 0) return true;
  return false;
}

}  // namespace hair
