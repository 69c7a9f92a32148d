// STAFF ONLY. Guides that a control mesh makes one system, with the reference's exercises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hair/linked_guides/frame_torque.h"
#include "hair/linked_guides/linked_guides.h"
#include "hair/linked_guides/make_control_mesh.h"
#include "hair/linked_guides/strip_contacts.h"
#include "hair/simulation/simulation.h"
#include "hair/strand/turns.h"
#include "handout/check/derivative.h"
#include "solver/test_refusal.h"

namespace reference_tests {
namespace {

using checks::scattered_vector;
using Eigen::VectorXd;
using hair::Matrix3d, hair::StaticLink, hair::Vector3d;

constexpr double kStep = 1.0 / 240;

// Guides of 8 segments of a centimetre that hang in a row, a centimetre apart.
hair::Description guides(int count, const Vector3d& direction = Vector3d(0, 0, -1)) {
  hair::Description hair;
  hair.method = hair::Method::implicit_euler;
  hair.step = kStep;
  for (int i = 0; i < count; ++i) {
    hair::StrandSpec spec;
    spec.elements = 8;
    spec.length = 0.08;
    spec.root.position = Vector3d(0.01 * i, 0, 0);
    spec.root.axis = direction.normalized();
    spec.root.side = hair::side_of(spec.root.axis);
    hair.strands.push_back(discretise(spec));
  }
  return hair;
}

hair::Description linked(hair::Description hair, const hair::MeshSpec& spec) {
  const int count = static_cast<int>(hair.strands.size());
  hair.mesh = control_mesh(hair.strands, hair::neighbours({0}, count, hair::Neighbours::rows), spec);
  return hair;
}

VectorXd positions(const hair::Simulation& simulation) {
  VectorXd all(0);
  for (int i = 0; i < simulation.strands(); ++i) {
    const VectorXd& x = simulation.state(i).x;
    all.conservativeResize(all.size() + x.size());
    all.tail(x.size()) = x;
  }
  return all;
}

TEST(ControlMesh, LinksNeighboursInRowsAndAcrossThem) {
  const auto rows = hair::neighbours({0, 3, 5}, 8, hair::Neighbours::rows);
  EXPECT_EQ(rows, (std::vector<hair::Pair>{{0, 1}, {1, 2}, {3, 4}, {5, 6}, {6, 7}}));
  const auto both = hair::neighbours({0, 3, 5}, 8, hair::Neighbours::both);
  EXPECT_EQ(both, (std::vector<hair::Pair>{
                      {0, 1}, {1, 2}, {0, 3}, {1, 4}, {3, 4}, {3, 5}, {4, 6}, {5, 6}, {6, 7}}));
}

TEST(ControlMesh, JoinsNearestParticlesAndLaysStripsOfOneOrientation) {
  const hair::Description hair = linked(guides(3), {1, 1, 2, hair::StripLaw{0.001, 1, 0}});
  ASSERT_EQ(hair.mesh->links.size(), 16U);
  for (std::size_t l = 0; l < 16; ++l) {
    const StaticLink& link = hair.mesh->links[l];
    EXPECT_EQ(link.b, link.a + 9) << "the particle beside it";
    EXPECT_NEAR(link.length, 0.01, 1e-12);
  }
  ASSERT_EQ(hair.mesh->strips.size(), 2U);
  const VectorXd x = positions(hair::Simulation(hair));
  for (const auto& strip : hair.mesh->strips)
    for (const auto& [a, b, c] : strip.triangles) {
      const Vector3d corner = x.segment<3>(3 * a);
      const Vector3d area = (x.segment<3>(3 * b) - corner).cross(x.segment<3>(3 * c) - corner);
      EXPECT_NEAR(area.y(), 1e-4, 1e-12);
    }
}

TEST(GuideFrames, TurnWithTheGuide) {
  VectorXd x = scattered_vector(24, 1);
  const Vector3d tangent = Vector3d(1, 2, 2) / 3, normal = Vector3d(2, 1, -2) / 3;
  std::vector<Matrix3d> frames(8), turned(8);
  hair::guide_frames(x, tangent, normal, frames);
  const Matrix3d R = Eigen::AngleAxisd(1.1, tangent.cross(Vector3d(1, 0, 0)).normalized()).matrix();
  for (int i = 0; i < 8; ++i) x.segment<3>(3 * i) = (R * x.segment<3>(3 * i)).eval() + Vector3d(1, 2, 3);
  hair::guide_frames(x, R * tangent, R * normal, turned);
  for (int i = 0; i < 8; ++i) {
    EXPECT_LE((turned[i] - R * frames[i]).norm(), 1e-12) << "particle " << i;
    EXPECT_LE((frames[i].transpose() * frames[i] - Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_GT(frames[i].determinant(), 0);
  }
}

// H9's part and this one together: the force is compared with the energy of frames that turn by the least
// rotation, and the product with the force for links at rest; elsewhere it is symmetric and definite.
TEST(FrameTorque, CompletesWhatHeldFramesLeaveOut) {
  const std::vector<StaticLink> links = {{1, 2, Vector3d(0.3, 0.2, -0.5), 1, 2, 9, 9}};
  const VectorXd largest = VectorXd::Zero(1), x = scattered_vector(9, 3);
  hair::FrameTorque torque(links, {0});
  torque.hold(largest);
  const Vector3d c0 = (x.segment<3>(3) - x.head<3>()).normalized();
  const auto frames_at = [&](const VectorXd& y) {
    const Vector3d c = (y.segment<3>(3) - y.head<3>()).normalized();
    return std::vector<Matrix3d>(3, hair::turn_between(c0, c).toRotationMatrix());
  };
  const auto force = [&](const VectorXd& y) {
    VectorXd f = VectorXd::Zero(9);
    add_link_force(links, frames_at(y), largest, y, f);
    torque.add_force(frames_at(y), y, f);
    return f;
  };
  checks::expect_force(
      force(x), [&](const VectorXd& y) { return link_energy(links, frames_at(y), largest, y); }, x, 1, 10);
  const auto product = [&](const VectorXd& y, const VectorXd& dx) {
    VectorXd df = VectorXd::Zero(9);
    add_link_product(links, largest, dx, df);
    torque.add_product(frames_at(y), y, dx, df);
    return df;
  };
  VectorXd rest = x;
  rest.tail<3>() = x.segment<3>(3) + links[0].offset;
  for (const int which : {4, 5}) {
    const VectorXd dx = scattered_vector(9, which), other = scattered_vector(9, which + 10);
    checks::expect_product(product(rest, dx), force, rest, dx, 1, 10);
    EXPECT_NEAR(other.dot(product(x, dx)), dx.dot(product(x, other)), 1e-12);
    EXPECT_LE(dx.dot(product(x, dx)), 1e-12);
    EXPECT_LE(VectorXd(product(x, dx)).reshaped(3, 3).rowwise().sum().norm(), 1e-12) << "linear momentum";
  }
  EXPECT_LE(force(x).reshaped(3, 3).rowwise().sum().norm(), 1e-12) << "linear momentum";
  Vector3d about = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    about += Vector3d(x.segment<3>(3 * i)).cross(Vector3d(force(x).segment<3>(3 * i)));
  EXPECT_LE(about.cross(c0).norm(), 1e-12) << "the torque that is left is a twist about the chord";
}

// A mesh without stiffness couples nothing: strands move as without it, up to the solves' residuals (1e-10).
TEST(LinkedGuides, WithoutStiffnessMoveAsByThemselves) {
  const hair::Description alone = guides(3, Vector3d(1, 0, 1));
  hair::Simulation one(alone), other(linked(alone, {0, 1, 2, hair::StripLaw{0.001, 0, 0}}));
  ASSERT_FALSE(one.advance(100));
  ASSERT_FALSE(other.advance(100));
  EXPECT_LE((positions(one) - positions(other)).cwiseAbs().maxCoeff(), 1e-9);
}

// h^2 k / m is 100 times the explicit limit; guides that swing together keep their distances and their
// lengths.
TEST(LinkedGuides, AreStableFarBeyondTheExplicitLimit) {
  const hair::Description hair = guides(4, Vector3d(1, 0.5, 1));
  const double m = hair.strands[0].strand.mass[1], k = 400 * m / (kStep * kStep);
  hair::Simulation simulation(linked(hair, {k, 100, 100}));
  for (int step = 0; step < 480; ++step) {
    ASSERT_FALSE(simulation.step()) << "step " << step;
    for (int i = 0; i < 4; ++i)
      ASSERT_LE(simulation.body(i).measure(simulation.state(i).x, simulation.state(i).v).stretch, 0.01)
          << "step " << step;
  }
  EXPECT_EQ(simulation.work().unconverged, 0);
  for (int i = 0; i + 1 < 4; ++i)
    EXPECT_NEAR((simulation.state(i).x.tail<3>() - simulation.state(i + 1).x.tail<3>()).norm(), 0.01, 1e-3);
}

// The same bits again, after a restart too, with any number of threads.
TEST(LinkedGuides, BreakTheSameWayEachTime) {
  hair::Description hair = linked(guides(4), {0.001, 0.01, 0.1, hair::StripLaw{0.003, 0.05, 0.3}});
  for (int i = 0; i < 4; ++i) hair.strands[i].state.v.tail<12>() = 0.5 * scattered_vector(12, i);
  hair::Simulation one(hair);
  hair.jobs = 3;
  hair::Simulation other(hair);
  ASSERT_FALSE(one.advance(60));
  ASSERT_FALSE(other.advance(60));
  const VectorXd first = positions(one);
  EXPECT_EQ(first, positions(other));
  const std::vector<hair::BrokenLink> broken = one.mesh_record()->broken;
  EXPECT_GT(broken.size(), 1U);
  EXPECT_LT(broken.size(), hair.mesh->links.size());
  EXPECT_EQ(broken, other.mesh_record()->broken);
  one.restart(hair);
  EXPECT_TRUE(one.mesh_record()->broken.empty());
  ASSERT_FALSE(one.advance(60));
  EXPECT_EQ(first, positions(one)) << "what links remember is forgotten";
  EXPECT_EQ(broken, one.mesh_record()->broken);
  hair.mesh->links.clear();
  hair::Simulation unlinked(hair);
  ASSERT_FALSE(unlinked.advance(60));
  EXPECT_GT((first - positions(unlinked)).norm(), 1e-4) << "links do something";
}

// In the first step links were new: the record has the energy that they would hold at its end, and don't.
TEST(LinkedGuides, RecordTheEnergyThatLinksLose) {
  hair::Description hair = linked(guides(2), {0.001, 0.01, 0.3});
  hair.strands[1].state.v.tail<24>() = scattered_vector(24, 1);
  hair::Simulation simulation(hair);
  EXPECT_EQ(simulation.mesh_energy(positions(simulation)), 0) << "at rest";
  ASSERT_FALSE(simulation.step());
  const VectorXd x = positions(simulation);
  std::vector<Matrix3d> frames(18);
  for (int i = 0; i < 2; ++i)
    hair::guide_frames(x.segment(27 * i, 27), Vector3d(0, 0, -1), hair::side_of(Vector3d(0, 0, -1)),
                       std::span(frames).subspan(9 * static_cast<std::size_t>(i), 9));
  const std::vector<StaticLink>& links = hair.mesh->links;
  const double whole = link_energy(links, frames, VectorXd::Zero(links.size()), x);
  const hair::MeshRecord& record = *simulation.mesh_record();
  EXPECT_GT(record.worn_off, 0.1 * whole);
  EXPECT_GT(simulation.mesh_energy(x), 0) << "some links are worn and not broken";
  EXPECT_NEAR(record.worn_off, whole - simulation.mesh_energy(x), 1e-12 * whole);
  VectorXd stretches = VectorXd::Zero(links.size());
  remember_stretches(links, frames, x, stretches);
  EXPECT_EQ(static_cast<long>(record.broken.size()), (stretches.array() >= 0.3).count());
  for (const hair::BrokenLink& one : record.broken) {
    EXPECT_EQ(one.step, 1);
    EXPECT_GE(stretches[one.link], 0.3);
  }
}

// Guides whose links start at twice their length, and give them this energy. Implicit Euler damps, and frames
// are right to first order: the error in a second of motion is proportional to h.
TEST(LinkedGuides, WhatLinksGiveIsNoGain) {
  hair::Description hair = linked(guides(4), {0.005, 100, 100});
  hair.step = 1e-3;
  for (int i = 0; i < 4; ++i) hair.strands[i].state.x.reshaped(3, 9).row(0).array() += 0.01 * i;
  hair::Simulation simulation(hair);
  const double held = simulation.mesh_energy(positions(simulation));
  ASSERT_FALSE(simulation.advance(400));
  EXPECT_LT(simulation.mesh_energy(positions(simulation)), 0.5 * held);
  EXPECT_LE(simulation.watch().worst(hair::Concern::energy), 0.02);
}

// Guides of a bar that turns back and forth: roots move and turn, each with another velocity, and links
// transmit it.
TEST(LinkedGuides, WhatRootsGiveThroughLinksIsNoGain) {
  hair::Description hair = linked(guides(4), {0.02, 100, 100});
  hair.step = 1e-3;
  hair::Simulation simulation(hair);
  const Vector3d axis = Vector3d::UnitY(), down(0, 0, -1);
  double most = 0, weights = 0;
  for (int i = 0; i < 4; ++i) weights += simulation.strand(i).mass.sum() * hair.gravity.norm() * 0.08;
  for (int k = 0; k < 400; ++k) {
    const Eigen::AngleAxisd turn(2 * std::sin(0.02 * k), axis);
    for (int i = 0; i < 4; ++i) {
      simulation.set_root_velocity(i, 40 * std::cos(0.02 * k) * axis.cross(turn * Vector3d(0.01 * i, 0, 0)));
      simulation.set_root_frame(i, turn * down, turn * hair::side_of(down));
    }
    ASSERT_FALSE(simulation.step());
    most = std::max(most, simulation.mesh_energy(positions(simulation)));
  }
  EXPECT_GT(most, weights) << "links hold as much as would lift all guides by their length";
  EXPECT_LE(simulation.watch().worst(hair::Concern::energy), 0.02);
}

// The energy that a worn link no longer holds is neither a gain nor a loss, and steps with contacts have a
// row of their own.
TEST(LinkedEnergy, AddsUpWhatNothingGave) {
  hair::LinkedEnergy books({});
  books.after_step({.links_before = 1, .links_after = 0.5});
  books.after_step({.links_before = 0.25, .links_after = 0.75});
  EXPECT_EQ(books.gain(), 0.5) << "since the lowest, of the 1 J at the start";
  books.after_step({.links_before = 0.75, .links_after = 1, .root_work = -0.25});
  EXPECT_EQ(books.gain(), 1) << "and taken by roots";
  books.after_step({.links_before = 2, .links_after = 2});
  EXPECT_EQ(books.gain(), 1) << "frames turned";
  EXPECT_EQ(books.contact_gain(), 0);
  books.after_step(
      {.links_before = 2, .links_after = 2, .strips_before = 1, .strips_after = 1, .contacts = true});
  EXPECT_EQ(books.gain(), 1);
  EXPECT_EQ(books.contact_gain(), 0.5) << "of 1 J, and 1 J that came in by frames";
  books.after_step({.links_before = 2, .links_after = 2});
  EXPECT_EQ(books.gain(), 1) << "the strip is left: its energy goes from the row that it came into";
  books.restart();
  books.after_step({.links_before = 3, .links_after = 2.5});
  EXPECT_EQ(books.gain() + books.contact_gain(), 0);
}

// A strip of one triangle, 0.1 m thick, and a particle of another guide.
class StripContacts : public testing::Test {
 protected:
  // The side on which the particle touches the strip, there; 0: it does not touch.
  double side_at(double along, double height) {
    x_.tail<3>() << along, 0.2, height;
    contacts_.find(x_, VectorXd::Zero(15));
    return contacts_.all().empty() ? 0 : contacts_.all()[0].normal.z();
  }

  hair::ControlMesh mesh_{{}, {{{0, 1}, {{0, 1, 2}}}}, {0.1, 1, 0}};
  hair::StripContacts contacts_{mesh_, {0, 1, 3, 5}};  // the last guide's particle 4 touches
  VectorXd x_ = (VectorXd(15) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9, 0, 0, 0).finished();
};

// A particle belongs to the side on which it first touched, wherever it is later, until it is far away.
TEST_F(StripContacts, RememberTheSide) {
  EXPECT_EQ(side_at(0.2, 0.05), 1);
  EXPECT_EQ(side_at(0.2, -0.05), 1) << "it went through: it is pushed back";
  EXPECT_EQ(side_at(0.2, -0.15), 0) << "far away";
  EXPECT_EQ(side_at(0.2, -0.05), -1) << "it comes from the other side now";
  contacts_.forget();
  EXPECT_EQ(side_at(0.2, 0.05), 1);
}

// A step that moves a particle farther than the strip's thickness: if it is still near the strip, it belongs
// to its old side; if not, it went through, and is counted. A particle that passes the strip's edge is not
// counted.
TEST_F(StripContacts, CountWhatGoesThroughInOneStep) {
  EXPECT_EQ(side_at(0.2, 0.15), 0);
  EXPECT_EQ(side_at(0.2, -0.05), 1) << "it came from above, by twice the thickness";
  EXPECT_EQ(side_at(0.2, 0.15), 0);
  EXPECT_EQ(contacts_.passes(2), 0);
  EXPECT_EQ(side_at(0.2, -0.15), 0);
  EXPECT_EQ(contacts_.passes(2), 1) << "by three times the thickness";
  EXPECT_EQ(side_at(0.2, -5), 0);
  EXPECT_EQ(side_at(2, -0.15), 0);
  EXPECT_EQ(side_at(2, 0.15), 0) << "beside the strip";
  EXPECT_EQ(side_at(-0.9, 0.15), 0);
  EXPECT_EQ(side_at(0.5, -0.35), 0) << "it meets the plane where there is no strip";
  EXPECT_EQ(contacts_.passes(2), 1);
  EXPECT_EQ(side_at(0.2, -0.05), -1);
  EXPECT_EQ(side_at(0.2, 0.05), -1);
  EXPECT_EQ(side_at(0.2, 0.12), 0);
  EXPECT_EQ(contacts_.passes(2), 2) << "it leaves at the wrong side";
  EXPECT_EQ(contacts_.passes(0) + contacts_.passes(1), 0);
}

// Two guides with a strip between them, and a third across their way, 4 mm from it, that moves towards it,
// m/s.
hair::Description hair_before_a_strip(double speed, const std::optional<hair::StripLaw>& law) {
  hair::Description hair = guides(3);
  hair::StrandSpec spec;
  spec.elements = 8;
  spec.length = 0.08;
  spec.root.position = Vector3d(-0.025, 0.004, -0.04);
  spec.root.axis = Vector3d(1, 0, 0);
  spec.root.side = Vector3d(0, 0, 1);
  hair.strands[2] = discretise(spec);
  hair.gravity.setZero();
  hair.strands[2].state.v.reshaped(3, 9).row(1).setConstant(-speed);
  hair.mesh = control_mesh(hair.strands, std::vector<hair::Pair>{{0, 1}}, {0, 1, 2, law});
  return hair;
}

// A guide with a moving root is pulled against the strip between two others across its way: it stays outside,
// and without the strip it passes.
TEST(LinkedGuides, StripsKeepHairOut) {
  for (const bool strips : {true, false}) {
    hair::Simulation simulation(
        hair_before_a_strip(0.1, strips ? std::optional(hair::StripLaw{0.003, 50, 0.2}) : std::nullopt));
    double lowest = 1;
    for (int step = 0; step < 40; ++step) {
      ASSERT_FALSE(simulation.step());
      const auto& third = simulation.state(2).x;
      lowest = std::min(lowest, third[3 * 5 + 1] - simulation.state(0).x[3 * 4 + 1]);
    }
    EXPECT_EQ(simulation.watch().worst(hair::Concern::passes), 0);
    if (strips)
      EXPECT_GT(lowest, -0.002) << "beside the strip";
    else
      EXPECT_LT(lowest, -0.004) << "through where the strip would be";
  }
}

// In a step it moves by 13 mm, four times the strip's thickness: the strip does not notice it, and a warning
// reports this.
TEST(LinkedGuides, WarnOfStepsThatAreTooLongForStrips) {
  hair::Simulation simulation(hair_before_a_strip(3, hair::StripLaw{0.003, 50, 0.2}));
  ASSERT_FALSE(simulation.advance(3));
  const std::vector<hair::Warning> warnings = simulation.watch().warnings();
  const auto passes = std::find_if(warnings.begin(), warnings.end(), [](const hair::Warning& one) {
    return one.concern->concern == hair::Concern::passes;
  });
  ASSERT_NE(passes, warnings.end());
  EXPECT_EQ(passes->strand, 2);
  EXPECT_EQ(passes->strands, 1);
  EXPECT_EQ(passes->step, 2) << "contacts are looked for at the beginning of the next step";
  EXPECT_GE(passes->size, 1);
}

TEST(LinkedGuides, RefuseWhatCantBeLinked) {
  const auto said = [](hair::Description hair) {
    return tests::refusal<std::invalid_argument>([&] { hair::Simulation simulation(std::move(hair)); });
  };
  const hair::Description right = linked(guides(2), {1, 1, 2});
  EXPECT_EQ(said(right), "");
  hair::Description wrong = right;
  wrong.method = hair::Method::predictor_corrector;
  EXPECT_EQ(said(wrong), "a control mesh moves by implicit_euler, and not by predictor_corrector");
  wrong = right;
  wrong.mesh->links[0].a = 18;
  EXPECT_NE(said(wrong), "");
  wrong = right;
  wrong.mesh->links[0].breaks = 0.5;
  EXPECT_NE(said(wrong), "");
}

}  // namespace
}  // namespace reference_tests
