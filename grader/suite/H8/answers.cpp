// STAFF ONLY.
#include "grader/suite/H8/answers.h"

#include "grader/suite/numbers.h"
#include "grader/wire/helix_message.h"
#include "grader/wire/strand_message.h"

namespace grader::h8 {
namespace {

template <typename Get>
auto only(MessageReader reply, Get get) {
  const auto value = get(reply);
  reply.expect_end();
  return value;
}

VectorXd only_vector(MessageReader reply, Eigen::Index size) {
  return only(std::move(reply), [size](MessageReader& from) { return get_vector(from, size); });
}

MessageWriter place(int function, const MaterialFrame& start, const Vector3d& curvature, double s) {
  MessageWriter message;
  message.put(function);
  put(message, start);
  put_vector3(message, curvature);
  message.put(s);
  return message;
}

MessageWriter placed(int function, const Hair& hair) {
  MessageWriter message;
  message.put(function);
  if (function == 8) put(message, hair.strand());
  put(message, hair.motion.elements);
  put(message, hair.motion.points);
  return message;
}

std::string in_words(const Hair& hair) {
  double most = 0;
  for (const hair::HelixElement& element : hair.motion.elements)
    most = std::max(most, element.length * element.curvature.norm());
  return std::to_string(hair.motion.elements.size()) + " elements that wind by " + std::to_string(most) +
         " at most, " + std::to_string(hair.motion.points.size()) + " points";
}

}  // namespace

std::array<double, 8> ask_stumpff(Trial& trial, double x) {
  MessageWriter message;
  message.put(0).put(x);
  trial.describe("x = " + std::to_string(x));
  const VectorXd numbers = only_vector(ask_alone(trial, message), 8);
  std::array<double, 8> c{};
  std::copy(numbers.begin(), numbers.end(), c.begin());
  return c;
}

MaterialFrame ask_frame(Trial& trial, const MaterialFrame& start, const Vector3d& curvature, double s) {
  trial.describe("an element that winds by " + std::to_string(s * curvature.norm()));
  return only(ask_alone(trial, place(1, start, curvature, s)), get_frame);
}

hair::HelixJacobian ask_jacobian(Trial& trial, const MaterialFrame& start, const Vector3d& curvature,
                                 double s) {
  trial.describe("an element that winds by " + std::to_string(s * curvature.norm()));
  return only(ask_alone(trial, place(5, start, curvature, s)), get_jacobian);
}

std::vector<hair::HelixElement> ask_carried(Trial& trial, const MaterialFrame& root,
                                            const std::vector<hair::HelixElement>& elements) {
  MessageWriter message;
  message.put(2);
  put(message, root);
  put(message, elements);
  trial.describe(std::to_string(elements.size()) + " elements");
  std::vector<hair::HelixElement> carried = only(ask_alone(trial, message), get_elements);
  if (carried.size() != elements.size()) throw MalformedMessage("another number of elements");
  return carried;
}

VectorXd ask_stiffness(Trial& trial, const HelixStrand& strand) {
  MessageWriter message;
  message.put(3);
  put(message, strand);
  return only_vector(ask_alone(trial, message), strand.natural.size());
}

VectorXd ask_elastic(Trial& trial, const HelixStrand& strand, const VectorXd& q) {
  MessageWriter message;
  message.put(4);
  put(message, strand);
  put(message, q);
  return only_vector(ask_alone(trial, message), q.size());
}

VectorXd ask_force(Trial& trial, const Hair& hair) {
  trial.describe(in_words(hair));
  return only_vector(ask_alone(trial, placed(6, hair)), hair.q.size());
}

MatrixXd ask_mass(Trial& trial, const Hair& hair) {
  trial.describe(in_words(hair));
  const Eigen::Index size = hair.q.size();
  return only_vector(ask_alone(trial, placed(7, hair)), size * size).reshaped(size, size);
}

VectorXd ask_step(Trial& trial, const Hair& hair, double h) {
  MessageWriter message = placed(8, hair);
  put(message, hair.q);
  put(message, hair.rates);
  message.put(h);
  trial.describe(in_words(hair) + ", h = " + std::to_string(h) + " s");
  return only_vector(ask_alone(trial, message), hair.q.size());
}

}  // namespace grader::h8
