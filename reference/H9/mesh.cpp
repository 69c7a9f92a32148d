// STAFF ONLY. Draws links, triangles and contacts for H9's cases.
#include "reference/H9/answers.h"

#include "grader/judge/cases/random.h"

namespace grader::h9 {

double LinkedHairs::size() const {
  double sum = 0;
  for (const StaticLink& link : links)
    sum += link.stiffness * (2 * x.cwiseAbs().maxCoeff() + link.offset.norm());
  return sum;
}

Vector3d some_direction(Random& random) {
  return Vector3d(random_vector(random, 3)).normalized();
}

LinkedHairs some_linked_hairs(Random& random, int links, Frames frames, Wear wear, Pull pull) {
  const int particles = links + 2;
  LinkedHairs hairs;
  hairs.x = random_vector(random, Eigen::Index{3} * particles, 0.05);
  hairs.largest.resize(links);
  for (int i = 0; i < particles; ++i) {
    hairs.frames.push_back(Matrix3d::Identity());
    if (frames == Frames::straight) continue;
    const double angle = random.uniform(0.3, 3);
    hairs.frames.back() = Eigen::AngleAxisd(angle, some_direction(random)).matrix();
  }
  for (int l = 0; l < links; ++l) {
    StaticLink link;
    link.a = random.integer(0, particles - 1);
    link.b = (link.a + random.integer(1, particles - 1)) % particles;
    const double offset = random.log_uniform(0.003, 0.03);
    link.offset = offset * some_direction(random);
    link.length = link.offset.norm() * random.uniform(0.5, 2);
    link.stiffness = random.log_uniform(0.01, 10);
    link.yields = random.uniform(0.1, 1);
    link.breaks = link.yields + random.uniform(0.2, 1);
    if (pull == Pull::little) {
      const double pulled = link.length * link.yields * random.uniform(0.1, 0.9);
      const Vector3d d = pulled * some_direction(random);
      link.offset = hairs.frames[link.a].transpose() * (hairs.x.segment<3>(3 * Eigen::Index{link.b}) -
                                                        hairs.x.segment<3>(3 * Eigen::Index{link.a}) - d);
    }
    hairs.largest[l] = 0;  // new links do not show mistakes about worn ones
    if (wear == Wear::some && l % 3 != 0)
      hairs.largest[l] =
          l % 3 == 1 ? random.uniform(0.5 * link.yields, link.breaks) : link.breaks * random.uniform(1, 3);
    hairs.links.push_back(link);
  }
  return hairs;
}

NearTriangle near_triangle(Random& random, const Vector3d& shares, double height) {
  NearTriangle near{VectorXd(12), VectorXd::Zero(12), random.log_uniform(0.001, 0.01)};
  const Vector3d at = random_vector(random, 3, 0.05), along = some_direction(random),
                 across = along.cross(some_direction(random)).normalized(), normal = along.cross(across);
  const double size = random.log_uniform(0.005, 0.02);
  const double foot = random.uniform(-0.2, 1.2), height_of_triangle = random.uniform(0.3, 1);
  near.x << at, at + size * along, at + size * (foot * along + height_of_triangle * across), at;
  Vector3d point = height * near.thickness * normal;
  for (int j = 0; j < 3; ++j) point += shares[j] * near.x.segment<3>(3 * j);
  near.x.tail<3>() = point;
  return near;
}

double Contacts::size() const {
  return law.stiffness * (law.thickness + 4 * x.cwiseAbs().maxCoeff()) * static_cast<double>(contacts.size());
}

Contacts some_contacts(Random& random, int contacts) {
  constexpr int kCorners = 6;
  const int particles = kCorners + contacts;
  Contacts made;
  made.law = {random.log_uniform(0.001, 0.01), random.log_uniform(0.1, 10), random.uniform(0.1, 1)};
  made.x = random_vector(random, Eigen::Index{3} * particles, 0.02);
  made.inverse_mass.resize(particles);
  for (double& inverse : made.inverse_mass) inverse = 1 / random.log_uniform(1e-6, 1e-4);
  made.inverse_mass[random.integer(0, kCorners - 1)] = 0;
  for (int c = 0; c < contacts; ++c) {
    StripContact contact;
    contact.point = kCorners + c;
    const int first = random.integer(0, kCorners - 1);
    contact.corners = {first, (first + 2) % kCorners, (first + 1) % kCorners};
    Vector3d shares;
    for (double& share : shares) share = random.uniform(0.05);
    shares /= shares.sum();
    contact.shares = {shares[0], shares[1], shares[2]};
    contact.normal = some_direction(random);
    contact.weight = random.uniform(0.1, 1);
    // The point has moved sideways, too, as after a step.
    Vector3d point = 0.1 * made.law.thickness * contact.normal.cross(some_direction(random));
    const double height = c == 0   ? random.uniform(-0.9, 0.9)
                          : c == 1 ? random.uniform(1.1, 2)
                                   : random.uniform(-0.5, 0.95);
    point += height * made.law.thickness * contact.normal;
    for (int j = 0; j < 3; ++j) point += shares[j] * made.x.segment<3>(3 * Eigen::Index{contact.corners[j]});
    made.x.segment<3>(3 * Eigen::Index{contact.point}) = point;
    made.contacts.push_back(contact);
  }
  return made;
}

LinkedHairs in_units(LinkedHairs hairs, const Units& units) {
  hairs.x *= units.length;
  for (StaticLink& link : hairs.links)
    link.offset *= units.length, link.length *= units.length, link.stiffness *= units.mass;
  return hairs;
}

NearTriangle in_units(NearTriangle near, const Units& units) {
  near.x *= units.length, near.thickness *= units.length;
  return near;
}

Contacts in_units(Contacts contacts, const Units& units) {
  contacts.x *= units.length, contacts.inverse_mass /= units.mass;
  contacts.law.thickness *= units.length, contacts.law.stiffness *= units.mass;
  return contacts;
}

}  // namespace grader::h9
