// The public checks of H7, pass by pass: a pass is checked with right results of the passes before it, so
// that the first check that fails names the pass that is wrong. Every failure prints the input, what was
// expected, what came, the error and its bound. The contract is in hair/rigid_links.h.

#include "hair/rigid_links.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "check.h"
#include "derivative.h"

using namespace checks;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::JointType, hair::Link, hair::LinkPass, hair::Matrix3d;

namespace {

using Links = std::vector<Link>;
using Passes = std::vector<LinkPass>;

const Vector3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

// ---- Links

Link link_of(JointType joint, const Vector3d& u, const Vector3d& d, const Vector3d& r, double mass,
             const Matrix3d& tensor = Matrix3d::Zero()) {
  Link link;
  link.joint = joint;
  link.u = u;
  link.d = d;
  link.r = r;
  link.tensor = tensor;
  link.inertia.M = mass * Matrix3d::Identity();
  link.inertia.J = tensor;
  return link;
}

// Numbered and named as links must be: each hangs from the one before, after the base.
Links chain_of(const Links& links) {
  Links chain(1);
  int first = 0;
  for (const Link& link : links) {
    chain.push_back(link);
    chain.back().parent = static_cast<int>(chain.size()) - 2;
    chain.back().first = first;
    first += hair::rates_of(link.joint);
  }
  return chain;
}

int rates_of(const Links& links) {
  return links.size() == 1 ? 0 : links.back().first + hair::rates_of(links.back().joint);
}

// A mass m of weight m g at the end of a rod of length l, which has no mass, hangs from (0, 0, 0), and is
// turned by `angle` about y away from -z.
Links pendulum(double m, double l, double angle, double g = 0) {
  const Vector3d d = l * Vector3d(-std::sin(angle), 0, -std::cos(angle));
  Links links = chain_of({link_of(JointType::revolute, kY, d, d, m)});
  links[1].external.force = Vector3d(0, 0, -m * g);
  return links;
}

// Pendulums of 1 kg, 0.5 m, 0.3 rad and of 2 kg, 0.4 m, -1.2 rad. Both hang from the base, so neither feels
// the other.
Links two_pendulums() {
  Links links = chain_of({pendulum(1, 0.5, 0.3, 9.81)[1], pendulum(2, 0.4, -1.2, 9.81)[1]});
  links[2].parent = 0;
  return links;
}

// ---- A chain that can be moved: joints on any axes, three kinds of them.

struct Shape {
  JointType joint;
  Vector3d axis, joint_at, center;  // at q = 0, along the axes of the world
};

struct Placed {
  Links links;
  std::vector<Vector3d> position;  // the centres of mass
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {
      {JointType::revolute, kZ, Vector3d(0.1, -0.3, 0.2), Vector3d(0.3, 0.1, -0.2)},
      {JointType::prismatic, Vector3d(2, 3, 6) / 7, Vector3d(-0.1, 0.2, 0.3), Vector3d(0.1, -0.4, 0.2)},
      {JointType::revolute, Vector3d(6, -2, 3) / 7, Vector3d(0.2, 0.4, 0.1), Vector3d(0.2, 0.3, -0.1)},
      {JointType::revolute, Vector3d(-4, 4, 7) / 9, Vector3d(-0.3, 0.1, 0.2), Vector3d(0.1, -0.2, 0.4)}};
  return all;
}

Placed placed(const VectorXd& q) {
  Links links;
  Placed chain{{}, {Vector3d::Zero()}};
  const std::vector<double> masses = {2.3, 0.7, 3.1, 1.6};
  Matrix3d turned = Matrix3d::Identity();
  for (std::size_t i = 0; i < shapes().size(); ++i) {
    const Shape& shape = shapes()[i];
    const Vector3d to_joint = turned * shape.joint_at;
    const Vector3d u = turned * shape.axis;
    const bool slides = shape.joint == JointType::prismatic;
    if (!slides) turned = turned * Eigen::AngleAxisd(q[i], shape.axis).toRotationMatrix();
    const Vector3d d = turned * shape.center;
    const Vector3d r = slides ? Vector3d(to_joint + d + q[i] * u) : Vector3d(to_joint + d);
    const Matrix3d tensor = masses[i] * turned * Vector3d(0.1, 0.2, 0.25).asDiagonal() * turned.transpose();
    links.push_back(link_of(shape.joint, u, slides ? Vector3d(Vector3d::Zero()) : d, r, masses[i], tensor));
    chain.position.push_back(chain.position.back() + r);
  }
  chain.links = chain_of(links);
  return chain;
}

const VectorXd kQ = vector({0.3, 0.2, -0.7, 1.1});
const VectorXd kRates = vector({1.5, 0.7, -2, 0.9});

// Central differences over 1e-5 s: errors of 1e-10 times the third derivative, and of 1e-16 / 1e-5.
constexpr double kStep = 1e-5, kByDifferences = 1e-7;
const std::string kSource = "1e-7: the error of central differences over 1e-5 s";

// ---- Calls

Passes pass_1(const Links& links, const VectorXd& rates, const LinkPass& base = {}) {
  Passes passes(links.size());
  passes[0] = base;
  outward_velocities(links, rates, passes);
  return passes;
}

Passes pass_2(const Links& links, const VectorXd& Q, Passes passes) {
  inward_inertias(links, Q, passes);
  return passes;
}

VectorXd pass_3(const Links& links, const VectorXd& Q, Passes& passes) {
  VectorXd accelerations = VectorXd::Constant(rates_of(links), 1e3);
  outward_accelerations(links, Q, passes, accelerations);
  return accelerations;
}

VectorXd all_passes(const Links& links, const VectorXd& rates, const VectorXd& Q, Passes& passes) {
  passes = pass_2(links, Q, pass_1(links, rates, passes.empty() ? LinkPass() : passes[0]));
  return pass_3(links, Q, passes);
}

VectorXd one(double value) {
  return VectorXd::Constant(1, value);
}

// The force that each joint must carry by Newton's and Euler's laws, for its link and all links that hang
// from it, with its stiffening, less Q: 0 after three right passes. It does not use the recursion.
VectorXd unbalanced(const Links& links, const VectorXd& rates, const VectorXd& Q, const LinkPass& base = {}) {
  const Passes first = pass_1(links, rates, base);
  Passes passes = pass_2(links, Q, first);
  const VectorXd accelerations = pass_3(links, Q, passes);
  std::vector<hair::SpatialForce> needs(links.size());
  VectorXd left = -Q;
  for (std::size_t i = links.size() - 1; i > 0; --i) {
    const Link& link = links[i];
    needs[i] += link.inertia * passes[i].a + first[i].bias;
    const Vector3d torque = needs[i].torque + link.d.cross(needs[i].force);
    if (link.joint == JointType::spherical)
      left.segment<3>(link.first) += torque + link.stiffening * accelerations.segment<3>(link.first);
    else
      left[link.first] +=
          (link.joint == JointType::revolute ? link.u.dot(torque) : link.u.dot(needs[i].force)) +
          link.stiffening(0, 0) * accelerations[link.first];
    needs[link.parent] += to_parent(needs[i], link.r);
  }
  return left;
}

enum class Part { inertia, bias };

// Compares I^A or Z^A of the base with values from pass 1 alone. B and S are the links' velocities for each
// motion of the base and for each rate. The base needs B'(I (B a + S q" + c) + Z), where the joints' forces
// S'(...) are Q.
void expect_base(const Links& links, const VectorXd& rates, const VectorXd& Q, Part asked) {
  const auto n = static_cast<Eigen::Index>(Q.size());
  const auto six = [](const Vector3d& angular, const Vector3d& linear) {
    return (VectorXd(6) << angular, linear).finished();
  };
  MatrixXd A = MatrixXd::Zero(6 + n, 6 + n);  // (B S)' I (B S)
  VectorXd needed = VectorXd::Zero(6 + n);    // (B S)' (I c + Z)
  const Passes now = pass_1(links, rates);
  std::vector<hair::SpatialMotion> c(links.size());
  std::vector<MatrixXd> moves(links.size(), MatrixXd(6, 6 + n));
  for (Eigen::Index k = 0; k < 6 + n; ++k) {
    LinkPass base;
    if (k < 6) (k < 3 ? base.v.angular : base.v.linear)[k % 3] = 1;
    const VectorXd rate = k < 6 ? VectorXd(VectorXd::Zero(n)) : VectorXd(VectorXd::Unit(n, k - 6));
    const Passes moved = pass_1(links, rate, base);
    for (std::size_t i = 1; i < links.size(); ++i)
      moves[i].col(k) = six(moved[i].v.angular, moved[i].v.linear);
  }
  for (std::size_t i = 1; i < links.size(); ++i) {
    c[i] = to_child(c[links[i].parent], links[i].r) + now[i].c;
    const hair::SpatialForce own = links[i].inertia * c[i] + now[i].bias;
    MatrixXd I(6, 6);
    I << links[i].inertia.J, links[i].inertia.H, links[i].inertia.H.transpose(), links[i].inertia.M;
    A += moves[i].transpose() * I * moves[i];
    needed += moves[i].transpose() * six(own.torque, own.force);
  }
  const Eigen::LDLT<MatrixXd> joints(A.bottomRightCorner(n, n));
  const LinkPass base = pass_2(links, Q, now)[0];
  const std::string of = " of a base from which a chain of four links hangs, hinges and a slider",
                    source = "1e-11: rounding of 10 kg, and of some 100 N";
  if (asked == Part::inertia) {
    const MatrixXd left =
        A.topLeftCorner(6, 6) - A.topRightCorner(6, n) * joints.solve(A.bottomLeftCorner(n, 6));
    expect_matrix(base.inertia.M, left.bottomRightCorner<3, 3>(), 1e-11, "M of I^A" + of, source);
    expect_matrix(base.inertia.H, left.topRightCorner<3, 3>(), 1e-11, "H of I^A" + of, source);
    expect_matrix(base.inertia.J, left.topLeftCorner<3, 3>(), 1e-11, "J of I^A" + of, source);
  } else {
    const VectorXd left = needed.head(6) + A.topRightCorner(6, n) * joints.solve(Q - needed.tail(n));
    expect_entries(base.bias.force, left.tail<3>(), 1e-11, "the force in Z^A" + of, source);
    expect_entries(base.bias.torque, left.head<3>(), 1e-11, "the torque in Z^A" + of, source);
  }
}

}  // namespace

// ---- Pass 1

TEST(Velocities, AreThoseOfThePlaces) {
  const Placed after = placed(kQ + kStep * kRates), before = placed(kQ - kStep * kRates);
  const Passes passes = pass_1(placed(kQ).links, kRates);
  for (int i = 1; i <= 4; ++i)
    expect_entries(passes[i].v.linear, (after.position[i] - before.position[i]) / (2 * kStep), kByDifferences,
                   "v of link " + std::to_string(i) + ", compared with how its place changes", kSource);
  expect_entries(passes[1].v.angular, Vector3d(0, 0, 1.5), 1e-14, "omega of link 1, which turns about z");
  expect_entries(passes[2].v.angular, Vector3d(0, 0, 1.5), 1e-14,
                 "omega of link 2, which slides on link 1 and turns with it");
}

TEST(Velocities, BeginAtTheBase) {
  LinkPass base;
  base.v = {Vector3d(0, 0, 2), Vector3d(1, 0, 0)};
  const Passes passes = pass_1(pendulum(1, 0.5, 0), one(3), base);
  // The mass hangs at (0, 0, -0.5); turning about y at 3 rad/s moves it along -x at 1.5 m/s.
  expect_entries(passes[1].v.angular, Vector3d(0, 3, 2), 1e-14,
                 "omega of a pendulum on a base that turns about z");
  expect_entries(passes[1].v.linear, Vector3d(-0.5, 0, 0), 1e-14,
                 "its v, on a base that moves along x at 1 m/s");
}

TEST(Trees, GoFromParentToChild) {
  const Passes passes = pass_1(two_pendulums(), vector({3, 5}));
  expect_entries(
      passes[2].v.angular, Vector3d(0, 5, 0), 1e-14,
      "omega of a pendulum that hangs from the base, compared with another one that turns at 3 rad/s");
}

// By (4.23) with q" = 0, c^_i is the change of v^_i that does not come from the parent's acceleration.
TEST(MovingJoints, AccelerateWhatMovesOnACurve) {
  const auto at = [](double t) { return pass_1(placed(kQ + t * kRates).links, kRates); };
  const Passes after = at(kStep), before = at(-kStep), now = at(0);
  const Links links = placed(kQ).links;
  const auto change = [&](int i) {
    hair::SpatialMotion difference = after[i].v + (-1.0) * before[i].v;
    return 1 / (2 * kStep) * difference;
  };
  for (int i = 1; i <= 4; ++i) {
    const hair::SpatialMotion parents = i == 1 ? hair::SpatialMotion() : to_child(change(i - 1), links[i].r);
    const hair::SpatialMotion c = change(i) + (-1.0) * parents;
    const std::string name = " of link " + std::to_string(i) + ", compared with how its v^ changes";
    expect_entries(now[i].c.angular, c.angular, 10 * kByDifferences, "the first half of c^" + name, kSource);
    expect_entries(now[i].c.linear, c.linear, 10 * kByDifferences, "the second half of c^" + name, kSource);
  }
  // A mass that circles at 3 rad/s, 0.5 m from its joint, accelerates towards it by 4.5 m/s^2.
  expect_entries(pass_1(pendulum(1, 0.5, 0), one(3))[1].c.linear, Vector3d(0, 0, 4.5), 1e-14,
                 "c of a pendulum");
}

TEST(LinkForces, GiveEulersAndExternalForces) {
  Links links = chain_of({link_of(JointType::revolute, Vector3d(0.6, 0, 0.8), Vector3d::Zero(),
                                  Vector3d::Zero(), 2, Vector3d(1, 2, 3).asDiagonal())});
  links[1].external = {Vector3d(1, 2, 3), Vector3d(4, 5, 6)};
  const Passes passes = pass_1(links, one(5));
  // omega = (3, 0, 4), I omega = (3, 0, 12): omega x I omega = (0, 12 - 36, 0).
  expect_entries(passes[1].bias.force, Vector3d(-1, -2, -3), 1e-13,
                 "the force in Z^, for an external one of (1, 2, 3)");
  expect_entries(passes[1].bias.torque, Vector3d(-4, -24 - 5, -6), 1e-13,
                 "the torque in Z^: omega = (3, 0, 4), moments 1, 2, 3, an external torque of (4, 5, 6)");
}

// Twice the speed is twice v and four times c, however slow or fast.
TEST(OtherUnits, OfJointsOfAnySpeed) {
  const Links links = placed(kQ).links;
  const Passes expected = pass_1(links, kRates);
  for (const double scale : {0x1p-50, 0x1p30}) {
    const Passes found = pass_1(links, scale * kRates);
    for (int i = 1; i <= 4; ++i) {
      std::ostringstream of;
      of << " of link " << i << ", where all joints are " << scale << " times as fast, over that factor";
      expect_entries(found[i].v.linear / scale, expected[i].v.linear, 1e-12, "v" + of.str());
      expect_entries(found[i].c.linear / (scale * scale), expected[i].c.linear, 1e-12,
                     "the second half of c^" + of.str() + " squared");
    }
  }
}

// The passes hold other numbers before the call, those of a lighter second link, as from an earlier step.
TEST(ValuesBefore, OverwriteWhatStoodThereByOutwardVelocities) {
  const Links links = chain_of({pendulum(1, 0.5, 0.3)[1], pendulum(1, 0.4, -0.2)[1]});
  const VectorXd rates = vector({3, -1});
  const Passes fresh = pass_1(links, rates);
  Passes used = fresh;
  outward_velocities(links, rates, used);
  for (int i = 1; i <= 2; ++i) {
    const std::string name = " of link " + std::to_string(i) + ", after pass 1 has run twice";
    expect_entries(used[i].v.linear, fresh[i].v.linear, 1e-14, "v" + name);
    expect_entries(used[i].v.angular, fresh[i].v.angular, 1e-14, "omega" + name);
    expect_entries(used[i].c.linear, fresh[i].c.linear, 1e-14, "the second half of c^" + name);
    expect_entries(used[i].bias.torque, fresh[i].bias.torque, 1e-14, "the torque in Z^" + name);
  }
}

// ---- Pass 2

TEST(ValuesBefore, BeginWithTheInertiaOfEachLink) {
  Links links = pendulum(2, 0.5, 0);
  links[1].inertia.H(1, 2) = 0.25;
  links[1].inertia.J(1, 1) = 0.5;
  Passes before(2);
  for (LinkPass& pass : before) pass.inertia.M = 100 * Matrix3d::Identity();
  const Passes passes = pass_2(links, one(0), before);
  const std::string what = " of I^A of the last link: its own, whatever stood in its pass before";
  expect_matrix(passes[1].inertia.M, links[1].inertia.M, 1e-14, "M" + what);
  expect_matrix(passes[1].inertia.H, links[1].inertia.H, 1e-14, "H" + what);
  expect_matrix(passes[1].inertia.J, links[1].inertia.J, 1e-14, "J" + what);
}

TEST(Inertias, GainOfAPendulum) {
  EXPECT_NUMBER(pass_2(pendulum(2, 0.5, 0), one(0), Passes(2))[1].gain(0, 0), 1 / (2 * 0.25), 1e-14)
      << "1 / (m l^2) of 2 kg at 0.5 m";
}

TEST(Inertias, GainOfASlider) {
  const Links links = chain_of({link_of(JointType::prismatic, kX, Vector3d::Zero(), kZ, 4)});
  EXPECT_NUMBER(pass_2(links, one(0), Passes(2))[1].gain(0, 0), 0.25, 1e-14)
      << "1 / m of a slider of 4 kg along x";
}

// A rod without mass lets nothing through but what pulls along it, and what moves it along the joint's axis.
TEST(Inertias, OfAPendulumAreThoseOfItsRod) {
  const Passes passes = pass_2(pendulum(2, 0.5, 0), one(0), Passes(2));
  expect_matrix(passes[0].inertia.M, Matrix3d(Vector3d(0, 2, 2).asDiagonal()), 1e-14,
                "M of I^A of the base, to which a pendulum of 2 kg hangs down that turns about y");
}

TEST(ValuesBefore, BeginWithTheBasesInertiaToo) {
  Links links = pendulum(2, 0.5, 0);
  links[0].inertia.M = 5 * Matrix3d::Identity();
  Passes before(2);
  before[0].inertia.M = 100 * Matrix3d::Identity();
  expect_matrix(pass_2(links, one(0), before)[0].inertia.M, Matrix3d(Vector3d(5, 7, 7).asDiagonal()), 1e-14,
                "M of I^A of a base of 5 kg, to which a pendulum of 2 kg hangs down that turns about y");
}

// Compares all blocks of the base's I^A, and the whole of its Z^A.
TEST(Inertias, OfAChainAreWhatItsJointsLeave) {
  expect_base(placed(kQ).links, VectorXd::Zero(4), VectorXd::Zero(4), Part::inertia);
}

TEST(Biases, CarryForcesThroughJoints) {
  // 2 kg that hang 0.5 m down, pushed along x by 3 N: the rod turns, and nothing gets through. The joint's
  // torque of 0.5 N m about y accelerates the mass by 0.5 / (m l) along -x, and the base pushes back.
  Links links = pendulum(2, 0.5, 0);
  links[1].external.force = Vector3d(3, 0, -20);
  Passes passes = pass_1(links, one(0));
  passes = pass_2(links, one(0.5), passes);
  expect_entries(passes[0].bias.force, Vector3d(-1, 0, 20), 1e-13,
                 "Z^A of the base, a pendulum of 2 kg and 0.5 m, pushed by (3, 0, -20) N, Q = 0.5 N m: -Q/l "
                 "along x, and the weight");
  expect_entries(passes[0].bias.torque, Vector3d(0, 0.5, 0), 1e-13,
                 "the torque in Z^A of the same base, where the hinge is: Q about its axis y");
  // Circling at 2 rad/s, the mass pulls at the base by m l omega^2.
  Passes circling = pass_2(pendulum(2, 0.5, 0), one(0), pass_1(pendulum(2, 0.5, 0), one(2)));
  expect_entries(circling[0].bias.force, Vector3d(0, 0, 4), 1e-13,
                 "Z^A of the base, a pendulum of 2 kg that circles at 2 rad/s");
}

TEST(Biases, CarryTheForcesOfAChain) {
  Links links = placed(kQ).links;
  for (Link& link : links) link.external = {Vector3d(1, -2, 3), Vector3d(0.5, 0.1, -0.3)};
  expect_base(links, kRates, (VectorXd(4) << 1, -2, 0.5, 3).finished(), Part::bias);
}

TEST(Trees, GoFromChildToParent) {
  const VectorXd none = VectorXd::Zero(2);
  const Passes both = pass_2(two_pendulums(), none, pass_1(two_pendulums(), none));
  Matrix3d expected = Matrix3d::Zero();
  for (const Links& alone : {pendulum(1, 0.5, 0.3, 9.81), pendulum(2, 0.4, -1.2, 9.81)})
    expected += pass_2(alone, one(0), pass_1(alone, one(0)))[0].inertia.M;
  EXPECT_LE((both[0].inertia.M - expected).norm(), 1e-13)
      << "M of I^A of a base from which two pendulums hang, compared with the sum of those of either alone; "
         "it is\n"
      << both[0].inertia.M << "\nand not\n"
      << expected;
}

TEST(Trees, AddUpWhereTwoLinksHangFromOne) {
  const Links chain = placed(kQ).links;
  const Links first = chain_of({chain[3]}), second = chain_of({chain[4]});
  Links both = chain_of({chain[3], chain[4]});
  both[2].parent = 0;
  const auto base_of = [](const Links& links) {
    const VectorXd rates = VectorXd::Constant(rates_of(links), 2);
    return pass_2(links, rates, pass_1(links, rates))[0];
  };
  const LinkPass one = base_of(first), other = base_of(second), sum = base_of(both);
  const std::string
      of = " of a base from which two links hang, compared with the sum of those with one link each",
      source = "1e-12: rounding";
  expect_matrix(sum.inertia.M, one.inertia.M + other.inertia.M, 1e-12, "M of I^A" + of, source);
  expect_matrix(sum.inertia.H, one.inertia.H + other.inertia.H, 1e-12, "H of I^A" + of, source);
  expect_matrix(sum.inertia.J, one.inertia.J + other.inertia.J, 1e-12, "J of I^A" + of, source);
  expect_entries(sum.bias.force, one.bias.force + other.bias.force, 1e-12, "the force in Z^A" + of, source);
  expect_entries(sum.bias.torque, one.bias.torque + other.bias.torque, 1e-12, "the torque in Z^A" + of,
                 source);
}

TEST(AddedBySteps, AddWhatStiffensAJoint) {
  Links links = pendulum(2, 0.5, 0);
  links[1].stiffening(0, 0) = 1.5;
  const Passes passes = pass_2(links, one(0), Passes(2));
  EXPECT_NUMBER(passes[1].gain(0, 0), 0.5, 1e-14) << "1 / (m l^2 + stiffening) = 1 / (0.5 + 1.5)";
  EXPECT_NUMBER(passes[0].inertia.M(0, 0), 2 * 0.75, 1e-14) << "m (1 - m l^2 / (m l^2 + stiffening))";
  Links two = chain_of({pendulum(1, 0.4, 0)[1], links[1]});
  EXPECT_NUMBER(pass_2(two, VectorXd::Zero(2), Passes(3))[2].gain(0, 0), 0.5, 1e-14)
      << "the same of a pendulum that hangs from another one";
}

// Implicit steps add to a link's inertia.
TEST(AddedBySteps, TakeTheInertiaThatALinkHas) {
  Links links = pendulum(2, 0.5, 0);
  links[1].inertia.M(0, 0) = 3;
  links[1].inertia.H(1, 2) = 0.25;
  links[1].inertia.J(1, 1) = 0.5;
  const Passes passes = pass_2(links, one(0), Passes(2));
  EXPECT_NUMBER(passes[1].gain(0, 0), 1 / (3 * 0.25 + 0.5), 1e-14)
      << "1 / (m l^2 + J) of a link that resists as 3 kg along x, 0.5 m below its joint";
}

// They add no mass that spins, so Z^ does not change.
TEST(AddedBySteps, LeaveEulersTermAlone) {
  Links links = placed(kQ).links;
  const Passes plain = pass_1(links, kRates);
  for (Link& link : links) link.inertia.J += Vector3d(0.3, 0.1, 0.2).asDiagonal();
  const Passes added = pass_1(links, kRates);
  for (int i = 1; i <= 4; ++i)
    expect_entries(added[i].bias.torque, plain[i].bias.torque, 1e-13,
                   "the torque in Z^ of link " + std::to_string(i) +
                       " of 4, where a step adds to its inertia.J, compared with that without");
}

TEST(LongChains, BeginAtTheTipOfALongChain) {
  const Links links = chain_of(Links(300, pendulum(2, 0.5, 0)[1]));
  const Passes passes = pass_2(links, VectorXd::Zero(300), Passes(301));
  EXPECT_NUMBER(passes[300].gain(0, 0), 1 / (2 * 0.25), 1e-14) << "1 / (m l^2) of the last of 300 links";
}

// ---- Pass 3

TEST(Accelerations, OfAPendulum) {
  for (const double angle : {0.0, 0.3, 1.5, 3.0}) {
    const Links links = pendulum(2, 0.5, angle, 9.81);
    Passes passes(2);
    const VectorXd found = all_passes(links, one(4), one(0), passes);
    expect_numbers(found, one(-9.81 / 0.5 * std::sin(angle)), 1e-12,
                   "q\" of a pendulum of 0.5 m at " + std::to_string(angle) + " rad: -g/l sin");
    const Vector3d d = links[1].d;
    expect_entries(passes[1].a.linear, Vector3d(0, found[0], 0).cross(d) - 16 * d, 1e-12,
                   "a of its mass, which circles at 4 rad/s");
  }
}

TEST(LongChains, OfABaseAlone) {
  const Links base(1);
  Passes passes;
  EXPECT_EQ(all_passes(base, VectorXd(0), VectorXd(0), passes).size(), 0)
      << "a base has no joint, and no rate";
}

TEST(Trees, OfTwoPendulumsOnOneBase) {
  const Links links = two_pendulums();
  Passes passes(3);
  const VectorXd found = all_passes(links, vector({4, -3}), VectorXd::Zero(2), passes);
  expect_numbers(found, vector({-9.81 / 0.5 * std::sin(0.3), 9.81 / 0.4 * std::sin(1.2)}), 1e-12,
                 "q\" of two pendulums that hang from the same base, at 0.3 and -1.2 rad: -g/l sin of each");
}

TEST(Accelerations, OfABaseThatFalls) {
  // In a lift whose rope is cut nothing has weight.
  const Links links = pendulum(2, 0.5, 0.7, 9.81);
  Passes passes = pass_1(links, one(0));
  passes[0].a.linear = Vector3d(0, 0, -9.81);
  passes = pass_2(links, one(0), passes);
  expect_numbers(pass_3(links, one(0), passes), one(0), 1e-12, "q\" of a pendulum in a lift that falls");
}

// The textbook's equations of two equal pendulums, one at the other's end. The lower one's angle to the
// vertical is p = q1 + q2:
//   2 q1" + cos(q1 - p) p" + sin(q1 - p) p'^2 + 2 g/l sin q1 = 0,
//   p" + cos(q1 - p) q1" - sin(q1 - p) q1'^2 + g/l sin p = 0.
TEST(Accelerations, OfADoublePendulum) {
  const double l = 0.4, g = 9.81, q1 = 0.8, p = -0.5, q1_rate = 2, p_rate = -3;
  Links links = chain_of({pendulum(1, l, q1, g)[1], pendulum(1, l, p, g)[1]});
  const VectorXd rates = vector({q1_rate, p_rate - q1_rate});
  Passes passes(3);
  const VectorXd found = all_passes(links, rates, VectorXd::Zero(2), passes);
  const double c = std::cos(q1 - p), s = std::sin(q1 - p);
  const double right_1 = -s * p_rate * p_rate - 2 * g / l * std::sin(q1);
  const double right_2 = s * q1_rate * q1_rate - g / l * std::sin(p);
  const double q1_expected = (right_1 - c * right_2) / (2 - c * c),
               p_expected = (2 * right_2 - c * right_1) / (2 - c * c);
  expect_numbers(
      found, vector({q1_expected, p_expected - q1_expected}), 1e-11,
      "q\" of a double pendulum of 0.4 m and 0.4 m at 0.8 and -0.5 rad to the vertical, 2 and -3 rad/s");
}

TEST(Accelerations, TakeTheGainOfPass2) {
  const Links links = pendulum(2, 0.5, 1.5, 9.81);
  Passes passes = pass_2(links, one(0), pass_1(links, one(0)));
  const double found = pass_3(links, one(0), passes)[0];
  passes[1].gain *= 3;
  EXPECT_NUMBER(pass_3(links, one(0), passes)[0], 3 * found, 1e-12) << "q\" with three times the gain";
}

TEST(Accelerations, ObeyNewtonAndEuler) {
  Links links = placed(kQ).links;
  for (Link& link : links) link.external = {Vector3d(1, -2, 3), Vector3d(0.5, 0.1, -0.3)};
  const VectorXd Q = vector({1, -2, 0.5, 3});
  LinkPass base;
  base.v = {Vector3d(0.3, -1, 0.4), Vector3d(1, 2, 0)};
  base.a = {Vector3d(1, 0, -2), Vector3d(0, 0, 9.81)};
  for (const double stiffening : {0.0, 0.7}) {
    for (Link& link : links) link.stiffening(0, 0) = stiffening;
    expect_numbers(
        unbalanced(links, kRates, Q, base), VectorXd::Zero(4), 1e-11,
        "the joints' forces that four links need, stiffening " + std::to_string(stiffening) + ", less Q",
        "1e-11: rounding of some 100 N and N m");
  }
}

// A pendulum's q" is -g/l sin, whatever it weighs; hair weighs 1e-8 kg.
TEST(OtherUnits, OfPendulumsOfAnySize) {
  for (const double m : {1e-8, 1e-16, 1e16})
    for (const double l : {1.0, 1e-6}) {
      Passes passes(2);
      const VectorXd found = all_passes(pendulum(m, l, 0.3, 9.81 * l), one(2), one(0), passes);
      std::ostringstream what;
      what << "q\" of a pendulum of " << m << " kg and " << l << " m under g = 9.81 l/s^2, at 0.3 rad";
      expect_entries(found, one(-9.81 * std::sin(0.3)), 1e-12, what.str());
    }
}

TEST(ValuesBefore, OverwriteWhatStoodThereByOutwardAccelerations) {
  const Links links = pendulum(2, 0.5, 1.5, 9.81);
  Passes passes = pass_2(links, one(0), pass_1(links, one(4)));
  pass_3(links, one(0), passes);
  const Vector3d once = passes[1].a.linear;
  pass_3(links, one(0), passes);
  expect_entries(passes[1].a.linear, once, 1e-12, "a of a link, after pass 3 has run twice");
}

// ---- Spherical joints: extra

TEST(SphericalJoints, TurnATopAsEulerSays) {
  // A free top about its centre of mass: I omega' + omega x I omega = Q.
  Links links = chain_of({link_of(JointType::spherical, Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(),
                                  1, Vector3d(1, 2, 3).asDiagonal())});
  const VectorXd omega = vector({2, 3, 5}), Q = vector({1, 0, -1});
  Passes passes(2);
  const VectorXd found = all_passes(links, omega, Q, passes);
  // omega x I omega = (3*15 - 5*6, 5*2 - 2*15, 2*6 - 3*2) = (15, -20, 6)
  expect_numbers(found, vector({(1 - 15) / 1.0, 20 / 2.0, (-1 - 6) / 3.0}), 1e-12,
                 "omega' of a top with the moments 1, 2, 3 at omega = (2, 3, 5), Q = (1, 0, -1)");
}

// Each spherical joint has three rates. Those of link i begin at links[i].first, which is not i - 1.
TEST(SphericalJoints, HaveThreeRatesEach) {
  const Link ball = link_of(JointType::spherical, Vector3d::Zero(), 0.5 * kX, kX, 1);
  const Links links = chain_of({ball, link_of(JointType::revolute, kZ, 0.5 * kX, kX, 1), ball});
  const VectorXd rates = vector({1, 2, 3, 10, 4, 5, 6});
  const Passes passes = pass_1(links, rates);
  expect_entries(passes[1].v.angular, Vector3d(1, 2, 3), 1e-13, "omega of link 1");
  expect_entries(passes[2].v.angular, Vector3d(1, 2, 13), 1e-13,
                 "omega of link 2, which turns about z at 10 rad/s");
  expect_entries(passes[3].v.angular, Vector3d(5, 7, 19), 1e-13,
                 "omega of link 3, a spherical joint with the rates 4, 5, 6");
}

// Passes 2 and 3 use the numbers of each joint for itself: q" = gain (Q - s'(I^A a^ + Z^A)).
TEST(SphericalJoints, HaveThreeForcesAndAccelerationsEach) {
  const Link ball = link_of(JointType::spherical, Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), 1,
                            Vector3d(1, 2, 4).asDiagonal());
  Links links = chain_of({ball, link_of(JointType::prismatic, kX, Vector3d::Zero(), kX, 5), ball});
  for (Link& link : links) link.parent = 0;
  const VectorXd Q = vector({1, 2, 4, 10, 3, 8, 20});
  Passes passes = pass_2(links, Q, pass_1(links, VectorXd::Zero(7)));
  expect_entries(
      pass_3(links, Q, passes), vector({1, 1, 1, 2, 3, 4, 5}), 1e-13,
      "q\" of two tops with the moments 1, 2, 4, torques (1, 2, 4) and (3, 8, 20) N m, and a slider of 5 kg "
      "between them in the list, 10 N");
}

// The axes of its rates are the world's and do not turn with the parent, so there is no omega x w.
TEST(SphericalJoints, TurnAboutAxesOfTheWorld) {
  const Links links = chain_of({link_of(JointType::spherical, Vector3d::Zero(), 0.5 * kX, 0.8 * kX, 1)});
  LinkPass base;
  base.v.angular = Vector3d(0, 0, 2);
  const Passes passes = pass_1(links, vector({0, 3, 0}), base);
  expect_entries(passes[1].c.angular, Vector3d::Zero(), 1e-13,
                 "the first half of c^, omega = (0, 0, 2), w = (0, 3, 0)");
  // omega x (omega x (r - d)) = -4 * 0.3 x, and (0, 3, 2) x ((0, 3, 2) x 0.5 x) = -13 * 0.5 x.
  expect_entries(passes[1].c.linear, Vector3d(-1.2 - 6.5, 0, 0), 1e-13,
                 "its second half, d = 0.5 x, r = 0.8 x");
}

namespace {

void expect_balance(bool stiffened) {
  Links links;
  for (int i = 0; i < 4; ++i) {
    const VectorXd numbers = scattered_vector(6, i + 1);
    links.push_back(link_of(JointType::spherical, Vector3d::Zero(), numbers.head<3>() / 2, numbers.tail<3>(),
                            1 + i, Vector3d(0.1, 0.2, 0.25).asDiagonal()));
  }
  links[2].joint = JointType::revolute;
  links[2].u = kZ;
  links = chain_of(links);
  for (Link& link : links) link.external.force = Vector3d(0, 0, -9.81);
  const VectorXd rates = 2 * scattered_vector(10, 7), Q = scattered_vector(10, 8);
  for (Link& link : links) {
    if (!stiffened) continue;
    if (link.joint == JointType::spherical)
      link.stiffening << 0.8, 0.1, -0.3, 0.1, 0.5, 0.2, -0.3, 0.2, 0.6;
    else
      link.stiffening(0, 0) = 0.8;
  }
  expect_numbers(unbalanced(links, rates, Q), VectorXd::Zero(10), 1e-11,
                 std::string("the joints' forces that three spherical joints and a revolute one need, ") +
                     (stiffened ? "stiffened" : "not stiffened") + ", less Q",
                 "1e-11: rounding of some 100 N m");
}

}  // namespace

TEST(SphericalJoints, ObeyNewtonAndEuler) {
  expect_balance(false);
}

TEST(SphericalJoints, AreStiffenedByAMatrix) {
  Links links = chain_of({link_of(JointType::spherical, Vector3d::Zero(), Vector3d::Zero(), kX, 1,
                                  Vector3d(1, 2, 3).asDiagonal())});
  links[1].stiffening << 1, 0.5, 0.2, 0.5, 2, -0.3, 0.2, -0.3, 1.5;
  for (const double scale : {1.0, 1e-20}) {  // kg m^2: hair is light
    Links light = links;
    light[1].stiffening *= scale;
    light[1].inertia.J *= scale;
    light[1].inertia.M *= scale;
    const Passes passes = pass_2(light, VectorXd::Zero(3), Passes(2));
    const Matrix3d resists = light[1].inertia.J + light[1].stiffening;
    EXPECT_LE((passes[1].gain * resists - Matrix3d::Identity()).norm(), 1e-13)
        << "gain * (J + stiffening) is 1 where the joint is at the centre of mass; the gain is\n"
        << passes[1].gain;
    // The base's I^A about the joint: J - J (J + stiffening)^-1 J; H and M are the mass's, at x.
    const Matrix3d J = light[1].inertia.J, lets = J - J * resists.inverse() * J;
    Matrix3d expected = lets;
    expected.diagonal().tail<2>().array() += scale;
    EXPECT_LE((passes[0].inertia.J - expected).norm(), 1e-13 * scale) << "J of I^A of the base; it is\n"
                                                                      << passes[0].inertia.J << "\nand not\n"
                                                                      << expected;
  }
}

TEST(SphericalJoints, ObeyNewtonAndEulerWhereTheyAreStiffened) {
  expect_balance(true);
}

int main(int argc, char** argv) {
  static const Links links = pendulum(1, 1, 0);
  static const Links top =
      chain_of({link_of(JointType::spherical, Vector3d::Zero(), kX, kX, 1, Matrix3d(Matrix3d::Identity()))});
  static Passes passes(2);
  static const VectorXd zero = VectorXd::Zero(3);
  static VectorXd result = zero;
  return run(
      argc, argv,
      {{"outward_velocities", [] { outward_velocities(links, zero.head(1), passes); }},
       {"inward_inertias", [] { inward_inertias(links, zero.head(1), passes); }, {"outward_velocities"}},
       {"outward_accelerations",
        [] { outward_accelerations(links, zero.head(1), passes, result.head(1)); },
        {"inward_inertias"}},
       {"spherical joints", [] {
          outward_velocities(top, zero, passes);
          inward_inertias(top, zero, passes);
          outward_accelerations(top, zero, passes, result);
        }}});
}
