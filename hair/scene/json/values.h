// Values of a scene's JSON: numbers, points and directions, with common bounds.
#pragma once

#include <string>

#include "hair/io/files/strict_json.h"
#include "particles/vectors.h"

namespace hair::json {

using Eigen::Vector3d;

inline constexpr double kFar = 1e6;      // m, of positions
inline constexpr double kFast = 1e6;     // m/s, of velocities; and of accelerations in m/s^2
inline constexpr double kLongest = 1e4;  // m, of lengths and radii
inline constexpr double kShortest = 1e-7;

// The value of `key` in `object`, or the default.
double number_or(const JsonValue& object, const std::string& key, double otherwise, double lowest,
                 double highest);
Vector3d vector_or(const JsonValue& object, const std::string& key, const Vector3d& otherwise, double bound);
bool boolean_or(const JsonValue& object, const std::string& key, bool otherwise);

Vector3d vector(const JsonValue& value, double bound);
Vector3d direction(const JsonValue& value);  // of any length but 0; returned with length 1
double length(const JsonValue& value);       // kShortest to kLongest
double mass(const JsonValue& value);         // kg, 1e-15 to 1e6

}  // namespace hair::json
