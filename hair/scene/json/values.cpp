#include "hair/scene/json/values.h"

namespace hair::json {

double number_or(const JsonValue& object, const std::string& key, double otherwise, double lowest,
                 double highest) {
  return object.has(key) ? object[key].number(lowest, highest) : otherwise;
}

Vector3d vector_or(const JsonValue& object, const std::string& key, const Vector3d& otherwise, double bound) {
  return object.has(key) ? vector(object[key], bound) : otherwise;
}

bool boolean_or(const JsonValue& object, const std::string& key, bool otherwise) {
  return object.has(key) ? object[key].boolean() : otherwise;
}

Vector3d vector(const JsonValue& value, double bound) {
  const auto numbers = value.three_numbers(-bound, bound);
  return {numbers[0], numbers[1], numbers[2]};
}

Vector3d direction(const JsonValue& value) {
  const Vector3d along = vector(value, kFar);
  const double size = along.norm();
  if (size < 1e-9) value.fail("has no direction; give one that is not [0, 0, 0]");
  return size == 1 ? along : Vector3d(along / size);
}

double length(const JsonValue& value) {
  return value.number(kShortest, kLongest);
}

double mass(const JsonValue& value) {
  return value.number(1e-15, 1e6);
}

}  // namespace hair::json
