// STAFF ONLY. The calls of H9; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "hair/static_links.h"

namespace grader {

template <>
struct Form<hair::StaticLink> {
  using T = hair::StaticLink;
  static constexpr auto fields =
      std::tuple(&T::a, &T::b, &T::offset, &T::length, &T::stiffness, &T::yields, &T::breaks);
};

template <>
struct Form<hair::StripLaw> {
  using T = hair::StripLaw;
  static constexpr auto fields = std::tuple(&T::thickness, &T::stiffness, &T::friction);
};

template <>
struct Form<hair::StripContact> {
  using T = hair::StripContact;
  static constexpr auto fields = std::tuple(&T::point, &T::corners, &T::shares, &T::normal, &T::weight);
};

}  // namespace grader

namespace grader::h9 {

// The vectors of n particles have 3n numbers, and every index is that of a particle.

inline void expect_particle(int number, Eigen::Index particles) {
  if (number < 0 || number >= particles) throw MalformedMessage("a particle that is not there");
}

inline void expect_size(Eigen::Index size, Eigen::Index expected) {
  if (size != expected)
    throw MalformedMessage(std::to_string(size) + " numbers in place of " + std::to_string(expected));
}

inline void expect_links(std::span<const hair::StaticLink> links, Eigen::Index largest,
                         Eigen::Index numbers) {
  expect_size(largest, static_cast<Eigen::Index>(links.size()));
  for (const hair::StaticLink& link : links)
    for (const int number : {link.a, link.b}) expect_particle(number, numbers / 3);
}

struct Strength {
  static void check(const hair::StaticLink&, double) {}
};
struct Stretches {
  static void check(std::span<const hair::StaticLink> links, const auto& frames, const auto& x,
                    const auto& largest) {
    expect_size(x.size(), 3 * static_cast<Eigen::Index>(frames.size()));
    expect_links(links, largest.size(), x.size());
  }
};
struct LinkForces {
  static void check(std::span<const hair::StaticLink> links, const auto& frames, const auto& largest,
                    const auto& x, const auto&... f) {
    Stretches::check(links, frames, x, largest);
    (expect_size(f.size(), x.size()), ...);
  }
};
struct LinkProduct {
  static void check(std::span<const hair::StaticLink> links, const auto& largest, const auto& dx,
                    const auto& df) {
    expect_links(links, largest.size(), dx.size());
    expect_size(df.size(), dx.size());
  }
};
struct Touch {
  static void check(int point, const std::array<int, 3>& corners, double, double, const auto& x,
                    const auto& tangents, const hair::StripContact&) {
    expect_size(tangents.size(), x.size());
    for (const int number : {point, corners[0], corners[1], corners[2]})
      expect_particle(number, x.size() / 3);
  }
};
// Contacts may name anything: in whole runs they are the student's own answers.
struct Strips {
  static void check(std::span<const hair::StripContact>, const hair::StripLaw&, const auto& x,
                    const auto&... others) {
    (expect_size(others.size(), x.size()), ...);
  }
};
struct Friction {
  static void check(std::span<const hair::StripContact> contacts, const hair::StripLaw& law,
                    const auto& inverse_mass, double, const auto& x, const auto& v) {
    Strips::check(contacts, law, x, v);
    expect_size(3 * inverse_mass.size(), x.size());
  }
};

template <auto function, class Check>
using Lean = Call<function, Contract{}, Check>;

struct Calls : CallList<Lean<hair::link_strength, Strength>, Lean<hair::remember_stretches, Stretches>,
                        Lean<hair::link_energy, LinkForces>, Lean<hair::add_link_force, LinkForces>,
                        Lean<hair::add_link_product, LinkProduct>, Lean<hair::touch_strip, Touch>,
                        Lean<hair::strip_energy, Strips>, Lean<hair::add_strip_force, Strips>,
                        Lean<hair::add_strip_product, Strips>, Lean<hair::apply_strip_friction, Friction>> {
  static constexpr const char* id = "H9";
};

}  // namespace grader::h9
