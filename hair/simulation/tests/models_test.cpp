// STAFF ONLY. The tables of models and methods, and bodies as those who play them see them.
#include "hair/simulation/models.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "hair/simulation/simulation.h"

namespace hair {
namespace {

StrandSpec curl() {
  StrandSpec spec;
  spec.form = Curly{0.005, 0.02};
  spec.elements = 24;
  spec.length = 0.12;
  spec.start = {true, Vector3d(1, 0, 0), 1, false};
  return spec;
}

TEST(Methods, EachHasItsRow) {
  std::set<std::string> ids;
  for (const MethodRow& row : methods()) {
    EXPECT_EQ(&row_of(row.method), &row) << row.id << " is not where the enumeration has it";
    EXPECT_TRUE(ids.insert(row.id).second) << row.id << " comes twice";
    ASSERT_FALSE(row.exercises.empty()) << row.id;
    EXPECT_GE(row.order, 1);
    EXPECT_GE(row.evaluations, 1);
  }
}

TEST(Models, EachIsFoundByItsName) {
  std::set<std::uint32_t> coordinates;
  for (const ModelRow& row : models()) {
    EXPECT_EQ(find_model(row.id), &row);
    EXPECT_TRUE(coordinates.insert(row.coordinates).second) << row.id;
  }
  EXPECT_EQ(find_model("mass_spring"), &models().front());
  EXPECT_EQ(models().front().coordinates, kPositions);
  EXPECT_EQ(find_model("no such model"), nullptr);
}

TEST(Models, WhatAModelCannotExpressItSaysAndRefuses) {
  const ModelRow& model = *find_model("mass_spring");
  StrandSpec spec = curl();
  EXPECT_EQ(model.why_not(spec), "");
  spec.clamped = false;
  EXPECT_NE(model.why_not(spec), "");
  EXPECT_THROW(model.make(spec, {}), std::invalid_argument);
}

TEST(Models, ASpecifiedStrandMovesAsTheSameStrandInSegments) {
  Description cut, specified;
  for (Description* one : {&cut, &specified}) {
    one->step = 1.0 / 60;
    one->obstacles.push_back({Sphere{Vector3d(0.05, 0, -0.06), 0.03}, 0.3});
  }
  cut.strands.push_back(discretise(curl()));
  specified.modelled.push_back({find_model("mass_spring"), curl()});
  Simulation one(cut), other(specified);
  ASSERT_EQ(other.strands(), 1);
  for (int k = 0; k < 30; ++k) {
    ASSERT_FALSE(one.step());
    ASSERT_FALSE(other.step());
  }
  Eigen::VectorXd q(other.body(0).size()), rate(other.body(0).size());
  other.body(0).read(q, rate);
  EXPECT_EQ(q, one.state(0).x);
  EXPECT_EQ(rate, one.state(0).v);
  EXPECT_EQ(one.work().contacts, other.work().contacts);
  EXPECT_GT(one.work().contacts, 0);

  // And again from the start.
  other.restart(specified);
  other.advance(30);
  Eigen::VectorXd again(q.size());
  other.body(0).read(again, rate);
  EXPECT_EQ(again, q);
}

TEST(Body, WhatIsWrittenIsRead) {
  Description description;
  description.strands.push_back(discretise(curl()));
  Simulation simulation(description);
  Body& body = simulation.body(0);
  const Eigen::VectorXd q = Eigen::VectorXd::Random(body.size()), rate = Eigen::VectorXd::Random(body.size());
  body.write(q, rate);
  Eigen::VectorXd x(3 * body.points()), v(x.size());
  body.read(x, v);
  EXPECT_EQ(x, q);
  EXPECT_EQ(v, rate);
  body.centre_line(q, rate, x, v);
  EXPECT_EQ(body.root_position(), Vector3d(x.head<3>()));
  EXPECT_EQ(*body.measure(q, rate).tip, Vector3d(x.tail<3>()));
  EXPECT_EQ(body.arc_lengths().size(), body.points());
  // Segments are chords, shorter than the curve by (curvature length)^2 / 24 and terms of the fourth power.
  const double bent = bend_at(curl().form, 0).curvature * curl().length / curl().elements;
  EXPECT_NEAR(body.arc_lengths()[body.points() - 1] / curl().length, 1 - bent * bent / 24, 1e-3);
}

// Two particles that nothing joins: the root, and one that a point force pulls at.
Description loose_particle(Method method) {
  Description description;
  description.method = method;
  description.gravity = Vector3d::Zero();
  description.point_forces = true;
  StrandStart start = discretise({});
  start.strand.mass = Eigen::Vector2d(1, 2);
  start.strand.rest_length = Eigen::VectorXd::Ones(1);
  start.strand.stretch_rigidity = start.strand.bend_rigidity = 0;
  start.state.x = start.state.v = Eigen::VectorXd::Zero(6);
  start.state.x[5] = -1;
  start.state.v[3] = 3;
  description.strands.push_back(start);
  return description;
}

// (m + h^2 k) dv = h (f - h k v): linearly implicit Euler with a force whose derivative is -k.
TEST(Body, ImplicitStepsFeelThePointForcesAndTheirStiffness) {
  const Description description = loose_particle(Method::implicit_euler);
  Simulation simulation(description);
  const double h = 0.1, k = 1e4, m = 2;
  const Vector3d f(5, 0, -7), v(3, 0, 0);
  const PointForce force{1, f, k * Eigen::Matrix3d::Identity()};
  Body& body = simulation.body(0);
  Eigen::MatrixXd scratch(body.scratch_rows(), body.scratch_columns());
  Work work;
  ASSERT_FALSE(body.step({h, 1e-12, {}, {&force, 1}}, scratch, work));
  const Vector3d after = v + h * (f - h * k * v) / (m + h * h * k);
  EXPECT_NEAR((simulation.state(0).v.tail<3>() - after).norm(), 0, 1e-11 * v.norm());
  // Without forces it goes on as it is.
  ASSERT_FALSE(body.step({h, 1e-12, {}, {}}, scratch, work));
  EXPECT_NEAR((simulation.state(0).v.tail<3>() - after).norm(), 0, 1e-11 * v.norm());
}

}  // namespace
}  // namespace hair
