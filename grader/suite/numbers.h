// STAFF ONLY. Functions that call nothing back: they get a message, and answer numbers and nothing else.
#pragma once

#include <Eigen/Core>
#include <span>

#include "grader/suite/trial.h"

namespace grader {

inline MessageReader ask_alone(Trial& trial, const MessageWriter& message) {
  return trial.ask(message, [](int, const auto&, auto&) -> bool { throw MalformedMessage("no operator"); });
}

// Both throw MalformedMessage if the reply is anything else.
inline double only_number(MessageReader reply) {
  const auto number = reply.get<double>();
  reply.expect_end();
  return number;
}
inline Eigen::VectorXd only_numbers(MessageReader reply, Eigen::Index size) {
  const std::vector<double> numbers = reply.get_doubles(static_cast<std::size_t>(size));
  reply.expect_end();
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), size);
}

inline std::span<const double> as_numbers(const Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

}  // namespace grader
