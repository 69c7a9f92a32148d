// STAFF ONLY. Inputs of H9's hidden cases: links, points near triangles, contacts.
#pragma once

#include "grader/judge/cases/random.h"
#include "hair/static_links.h"

namespace grader::h9 {

using Eigen::VectorXd;
using hair::Matrix3d, hair::StaticLink, hair::StripContact, hair::StripLaw, hair::Vector3d;

enum class Frames { straight, turned };
enum class Wear { none, some };   // with some, links are new, worn or broken
enum class Pull { little, any };  // with little, no link's stretch reaches `yields`

// Particles within about 5 cm, and links between them of about 1 cm.
struct LinkedHairs {
  std::vector<StaticLink> links;
  std::vector<Matrix3d> frames;
  VectorXd largest, x;

  double size() const;  // the size of a force, N
};
LinkedHairs some_linked_hairs(Random& random, int links, Frames frames, Wear wear, Pull pull);

Vector3d some_direction(Random& random);

// The last of four particles is near the triangle of the first three, which is about 1 cm wide.
struct NearTriangle {
  VectorXd x, tangents;
  double thickness;
};
// `height` is in thicknesses. The barycentric weights `shares` sum to 1.
NearTriangle near_triangle(Random& random, const Vector3d& shares, double height);

// Contacts of a strip with points of other hairs. Corners are shared; points are not. At least one contact
// presses, and one does not.
struct Contacts {
  std::vector<StripContact> contacts;
  StripLaw law;
  VectorXd x, inverse_mass;

  double size() const;  // the size of a force, N
};
Contacts some_contacts(Random& random, int contacts);

// The same in other units of mass and length: powers of 2, which change no digit.
struct Units {
  double mass = 1, length = 1;
};
LinkedHairs in_units(LinkedHairs hairs, const Units& units);
NearTriangle in_units(NearTriangle near, const Units& units);
Contacts in_units(Contacts contacts, const Units& units);

}  // namespace grader::h9
