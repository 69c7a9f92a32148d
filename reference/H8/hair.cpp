// STAFF ONLY. Draws hair for H8's cases.
#include "reference/H8/answers.h"

#include "grader/judge/cases/random.h"

namespace grader::h8 {
namespace {

VectorXd any_curl(Random& random, const VectorXd& lengths, double least, double most) {
  VectorXd q(3 * lengths.size());
  for (Eigen::Index i = 0; i < lengths.size(); ++i) {
    const double curvature = random.uniform(least, most) / lengths[i];
    q.segment<3>(3 * i) = curvature * any_direction(random);
  }
  return q;
}

HelixStrand any_strand(Random& random, int elements) {
  HelixStrand strand;
  strand.lengths.resize(elements);
  for (double& length : strand.lengths) length = random.uniform(0.005, 0.02);
  strand.line_density = random.log_uniform(5e-6, 2e-5);
  strand.bend_rigidity = random.log_uniform(0.5e-8, 3e-8);
  strand.twist_rigidity = strand.bend_rigidity * random.uniform(0.3, 0.8);
  strand.natural = any_curl(random, strand.lengths, 0.5, 3);
  return strand;
}

Hair lying(Random& random, const HelixStrand& strand, const VectorXd& q, const VectorXd& rates) {
  HelixMotion motion(strand);
  motion.place(any_frame(random), q);
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    hair::HelixPoint& point = motion.points[j];
    const double mass = point.inertia(0, 0);
    point.force = mass * random_vector(random, 3, 10);
    if (j % 3 == 1) {
      const Vector3d held = random_vector(random, 3, 1);
      point.inertia += mass * held * held.transpose();
    }
  }
  return {q, rates, strand, motion.elements, motion.points};
}

}  // namespace

Vector3d any_direction(Random& random) {
  return Vector3d(random_vector(random, 3)).normalized();
}

MaterialFrame any_frame(Random& random) {
  const Eigen::Quaterniond turn(Eigen::Vector4d(random_vector(random, 4)));
  return {random_vector(random, 3, 0.1), turn.normalized().toRotationMatrix()};
}

Hair random_hair(Random& random, const HairKind& kind) {
  const HelixStrand strand = any_strand(random, kind.elements);
  const VectorXd q = any_curl(random, strand.lengths, kind.least, kind.most);
  return lying(random, strand, q, any_curl(random, strand.lengths, 0, 10));
}

Hair straight_hair(Random& random, int elements) {
  const VectorXd none = VectorXd::Zero(3 * elements);
  return lying(random, any_strand(random, elements), none, none);
}

MaterialFrame in_units(MaterialFrame frame, const Units& units) {
  frame.position *= units.length;
  return frame;
}

Hair in_units(const Hair& hair, const Units& units) {
  const auto [mass, length] = units;
  Hair scaled = hair;
  scaled.q /= length, scaled.rates /= length;
  scaled.strand.lengths *= length;
  scaled.strand.natural /= length;
  scaled.strand.line_density *= mass / length;
  for (double* rigidity : {&scaled.strand.bend_rigidity, &scaled.strand.twist_rigidity})
    *rigidity *= mass * length * length * length;
  for (hair::HelixElement& element : scaled.elements) {
    element.length *= length, element.curvature /= length;
    element.start = in_units(element.start, units), element.end = in_units(element.end, units);
    element.at_end.turns *= length, element.at_end.moves *= length * length;
  }
  for (hair::HelixPoint& point : scaled.points) {
    point.s *= length, point.position *= length, point.moves *= length * length;
    point.force *= mass * length, point.inertia *= mass;
  }
  return scaled;
}

Sizes sizes_of(const Hair& hair) {
  const std::vector<hair::HelixElement>& elements = hair.elements;
  Sizes sizes{VectorXd::Zero(hair.q.size()), VectorXd::Zero(hair.q.size())};
  for (const hair::HelixPoint& point : hair.points) {
    const double inertia = point.inertia.norm(), force = point.force.norm();
    for (int i = 0; i <= point.element; ++i)
      for (int k = 0; k < 3; ++k) {
        const hair::HelixJacobian& J = elements[i].at_end;
        const double moves =
            i == point.element
                ? point.moves.col(k).norm()
                : J.moves.col(k).norm() +
                      J.turns.col(k).norm() * (point.position.norm() + elements[i].end.position.norm());
        sizes.force[3 * i + k] += moves * force;
        sizes.mass[3 * i + k] += moves * moves * inertia;
      }
  }
  sizes.mass = sizes.mass.cwiseSqrt();
  return sizes;
}

double System::error(const VectorXd& change) const {
  return (matrix * change - right).norm() / (matrix.norm() * change.norm() + right.norm());
}

Parts reference_parts(const Hair& hair, double h) {
  const Eigen::Index size = hair.q.size();
  Parts parts{MatrixXd(size, size), VectorXd(size), VectorXd(size), VectorXd(size)};
  hair::mass_matrix(hair.elements, hair.points, parts.M);
  hair::generalised_force(hair.elements, hair.points, parts.Q);
  hair::helix_stiffness(hair.strand, parts.K);
  hair::elastic_force(hair.strand, hair.q + h * hair.rates, parts.elastic);
  return parts;
}

System system_of(const Parts& parts, double h) {
  System system{parts.M, h * (parts.Q + parts.elastic)};
  system.matrix.diagonal() += h * h * parts.K;
  return system;
}

}  // namespace grader::h8
