// STAFF ONLY. The tables of models and methods, and bodies as their callers use them.
#include "hair/simulation/models.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

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
  constexpr std::pair<Method, std::string_view> kNamed[] = {
      {Method::forward_euler, "forward_euler"},
      {Method::symplectic_euler, "symplectic_euler"},
      {Method::midpoint, "midpoint"},
      {Method::runge_kutta_4, "runge_kutta_4"},
      {Method::implicit_euler, "implicit_euler"},
      {Method::predictor_corrector, "predictor_corrector"}};
  for (const auto& [method, id] : kNamed) EXPECT_EQ(row_of(method).id, id);
  std::set<std::string> ids;
  for (const MethodRow& row : methods()) {
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

struct Inexpressible {
  const char* model;
  void (*change)(StrandSpec& spec);  // changes a curl
  const char* why;
};

const Inexpressible kInexpressible[] = {
    {"mass_spring", [](StrandSpec& one) { one.clamped = false; }, "wavy and curly hair must be clamped"},
    {"rigid_links", [](StrandSpec& one) { one.fibre.skip_factor = 0.1; },
     "rigid links have no springs that skip a particle; the skip_factor must be 0"},
    {"rigid_links",
     [](StrandSpec& one) {
       one.start = {true, Vector3d(1, 0, 0), 1.5};
     },
     "rigid links don't stretch; the start's stretch must be 1"},
    {"super_helix", [](StrandSpec& one) { one.fibre.skip_factor = 0.1; },
     "super-helices have no springs that skip a particle; the skip_factor must be 0"},
    {"super_helix", [](StrandSpec& one) { one.fibre.stretch_factor = 0.5; },
     "super-helices don't stretch; the stretch_factor must be at least 1"},
    {"super_helix", [](StrandSpec& one) { one.fibre.bend_factor = 0; },
     "super-helices resist bends and twists; the bend_factor and the twist_factor must be above 0"},
    {"super_helix", [](StrandSpec& one) { one.fibre.joint_limit = 1; },
     "super-helices have no joints; leave the joint_limit out"},
    {"super_helix", [](StrandSpec& one) { one.clamped = false; }, "super-helices must be clamped"},
    {"super_helix", [](StrandSpec& one) { one.elements = 401; },
     "super-helices have at most 400 elements; each bends and twists, so that few are enough"},
    {"super_helix",
     [](StrandSpec& one) {
       one.elements = 3, one.form = Curly{0.001, 0.001}, one.length = 1;
     },
     "elements of super-helices wind up to 20 times; give the strand more of them"},
    {"super_helix",
     [](StrandSpec& one) {
       one.start = {true, Vector3d(1, 0, 0)};
     },
     "super-helices leave their roots along the roots' direction; give the start this direction, or leave it "
     "out"},
};

TEST(Models, WhatAModelCannotExpressItSaysAndRefuses) {
  Description description;
  description.method = Method::implicit_euler;
  for (const Inexpressible& row : kInexpressible) {
    const ModelRow& model = *find_model(row.model);
    StrandSpec spec = curl();
    spec.start = {};
    EXPECT_EQ(model.why_not(spec), "") << row.model;
    EXPECT_NO_THROW(model.make(spec, description)) << row.model;
    row.change(spec);
    EXPECT_EQ(model.why_not(spec), row.why);
    EXPECT_THROW(model.make(spec, description), std::invalid_argument) << row.why;
  }
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

}  // namespace
}  // namespace hair
