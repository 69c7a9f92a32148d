// STAFF ONLY.
#include "grader/wire/helix_message.h"

#include <gtest/gtest.h>

namespace grader {
namespace {

using hair::HelixElement, hair::HelixJacobian, hair::HelixPoint, hair::HelixStrand, hair::MaterialFrame,
    hair::Vector3d;

std::vector<HelixPoint> three_points() {
  std::vector<HelixPoint> points(3);
  points[1].element = points[2].element = 1;
  points[1].s = 2;
  points[1].moves(0, 2) = 3;
  points[2].force = Vector3d(4, 5, 6);
  points[2].inertia(2, 1) = 7;
  return points;
}

TEST(HelixMessage, GivesBackWhatWasPut) {
  HelixStrand strand{Eigen::VectorXd::Constant(2, 0.1), 1, 2, 3, Eigen::VectorXd::LinSpaced(6, 1, 6)};
  std::vector<HelixElement> elements(2);
  elements[1].length = 8;
  elements[1].curvature = Vector3d(9, 10, 11);
  elements[1].start.axes(1, 0) = 12;
  elements[1].end.position = Vector3d(13, 14, 15);
  elements[1].at_end.turns(0, 1) = 16;
  HelixJacobian jacobian;
  jacobian.moves(1, 2) = 17;
  MessageWriter message;
  put(message, strand);
  put(message, elements);
  put(message, three_points());
  put(message, jacobian);
  put(message, elements[1].end);
  put_vector3(message, Vector3d(18, 19, 20));

  MessageReader reader(message.bytes());
  const HelixStrand read = get_helix_strand(reader);
  EXPECT_EQ(read.lengths, strand.lengths);
  EXPECT_EQ(read.natural, strand.natural);
  EXPECT_EQ(read.twist_rigidity, 3);
  const std::vector<HelixElement> got = get_elements(reader);
  ASSERT_EQ(got.size(), 2u);
  EXPECT_EQ(got[1].length, 8);
  EXPECT_EQ(got[1].curvature, elements[1].curvature);
  EXPECT_EQ(got[1].start.axes, elements[1].start.axes);
  EXPECT_EQ(got[1].end.position, elements[1].end.position);
  EXPECT_EQ(got[1].at_end.turns, elements[1].at_end.turns);
  const std::vector<HelixPoint> points = get_points(reader, 2);
  EXPECT_EQ(points[1].s, 2);
  EXPECT_EQ(points[1].moves, three_points()[1].moves);
  EXPECT_EQ(points[2].force, Vector3d(4, 5, 6));
  EXPECT_EQ(points[2].inertia, three_points()[2].inertia);
  EXPECT_EQ(get_jacobian(reader).moves, jacobian.moves);
  EXPECT_EQ(get_frame(reader).position, elements[1].end.position);
  EXPECT_EQ(get_vector3(reader), Vector3d(18, 19, 20));
  reader.expect_end();
}

TEST(HelixMessage, RefusesStrandsThatAreNone) {
  MessageWriter none;
  put(none, std::vector<HelixElement>());
  MessageReader reader(none.bytes());
  EXPECT_THROW(get_elements(reader), MalformedMessage);

  MessageWriter other;
  put(other, HelixStrand{Eigen::VectorXd::Ones(2), 1, 1, 1, Eigen::VectorXd::Ones(5)});
  MessageReader other_reader(other.bytes());
  EXPECT_THROW(get_helix_strand(other_reader), MalformedMessage);

  for (const int wrong : {-1, 2, 0}) {  // the last: behind a point of element 1
    std::vector<HelixPoint> points = three_points();
    points[2].element = wrong;
    MessageWriter message;
    put(message, points);
    MessageReader of_points(message.bytes());
    EXPECT_THROW(get_points(of_points, 2), MalformedMessage) << wrong;
  }
}

}  // namespace
}  // namespace grader
