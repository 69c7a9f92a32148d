// STAFF ONLY.
#include "grader/wire/helix_message.h"

namespace grader {
namespace {

using hair::HelixElement, hair::HelixJacobian, hair::HelixPoint, hair::HelixStrand, hair::MaterialFrame,
    hair::Vector3d;

// What a whole is made of, one after the other, for those who put and for those who get.
template <typename Frame, typename Visit>
void visit_frame(Frame& frame, Visit one) {
  one(frame.position);
  one(frame.axes);
}
template <typename Jacobian, typename Visit>
void visit_jacobian(Jacobian& jacobian, Visit one) {
  one(jacobian.turns);
  one(jacobian.moves);
}
template <typename Element, typename Visit>
void visit_element(Element& element, Visit one) {
  one(element.curvature);
  visit_frame(element.start, one);
  visit_frame(element.end, one);
  visit_jacobian(element.at_end, one);
}
template <typename Point, typename Visit>
void visit_point(Point& point, Visit one) {
  one(point.position);
  one(point.moves);
  one(point.force);
  one(point.inertia);
}

auto writing_to(MessageWriter& message) {
  return [&message](const auto& part) {
    message.put(std::span<const double>(part.data(), static_cast<std::size_t>(part.size())));
  };
}

auto reading_from(MessageReader& message) {
  return [&message](auto& part) {
    const std::vector<double> numbers = message.get_doubles(static_cast<std::size_t>(part.size()));
    std::copy(numbers.begin(), numbers.end(), part.data());
  };
}

Eigen::VectorXd any_vector(MessageReader& message) {
  const std::vector<double> numbers = message.get_doubles();
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

void put_vector3(MessageWriter& message, const Vector3d& vector) {
  writing_to(message)(vector);
}

void put(MessageWriter& message, const MaterialFrame& frame) {
  visit_frame(frame, writing_to(message));
}

void put(MessageWriter& message, const HelixJacobian& jacobian) {
  visit_jacobian(jacobian, writing_to(message));
}

void put(MessageWriter& message, const HelixStrand& strand) {
  writing_to(message)(strand.lengths);
  message.put(strand.line_density).put(strand.bend_rigidity).put(strand.twist_rigidity);
  writing_to(message)(strand.natural);
}

void put(MessageWriter& message, const std::vector<HelixElement>& elements) {
  message.put(static_cast<int>(elements.size()));
  for (const HelixElement& element : elements) {
    message.put(element.length);
    visit_element(element, writing_to(message));
  }
}

void put(MessageWriter& message, const std::vector<HelixPoint>& points) {
  message.put(static_cast<int>(points.size()));
  for (const HelixPoint& point : points) {
    message.put(point.element).put(point.s);
    visit_point(point, writing_to(message));
  }
}

Vector3d get_vector3(MessageReader& message) {
  Vector3d vector;
  reading_from(message)(vector);
  return vector;
}

MaterialFrame get_frame(MessageReader& message) {
  MaterialFrame frame;
  visit_frame(frame, reading_from(message));
  return frame;
}

HelixJacobian get_jacobian(MessageReader& message) {
  HelixJacobian jacobian;
  visit_jacobian(jacobian, reading_from(message));
  return jacobian;
}

HelixStrand get_helix_strand(MessageReader& message) {
  HelixStrand strand;
  strand.lengths = any_vector(message);
  strand.line_density = message.get<double>();
  strand.bend_rigidity = message.get<double>();
  strand.twist_rigidity = message.get<double>();
  strand.natural = any_vector(message);
  if (strand.natural.size() != 3 * strand.lengths.size())
    throw MalformedMessage("natural coordinates of other elements");
  return strand;
}

std::vector<HelixElement> get_elements(MessageReader& message) {
  const int count = message.get<int>();
  if (count < 1) throw MalformedMessage("a strand without elements");
  std::vector<HelixElement> elements;
  for (int i = 0; i < count; ++i) {
    HelixElement element;
    element.length = message.get<double>();
    visit_element(element, reading_from(message));
    elements.push_back(element);
  }
  return elements;
}

std::vector<HelixPoint> get_points(MessageReader& message, std::size_t elements) {
  const int count = message.get<int>();
  std::vector<HelixPoint> points;
  for (int j = 0; j < count; ++j) {
    HelixPoint point;
    point.element = message.get<int>();
    if (point.element < (points.empty() ? 0 : points.back().element) ||
        point.element >= static_cast<int>(elements))
      throw MalformedMessage("points that are not in the order of the elements");
    point.s = message.get<double>();
    visit_point(point, reading_from(message));
    points.push_back(point);
  }
  return points;
}

}  // namespace grader
