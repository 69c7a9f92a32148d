// STAFF ONLY. The calls of H8; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "hair/super_helix.h"

namespace grader {

template <>
struct Form<hair::MaterialFrame> {
  static constexpr auto fields = std::tuple(&hair::MaterialFrame::position, &hair::MaterialFrame::axes);
};

template <>
struct Form<hair::HelixJacobian> {
  static constexpr auto fields = std::tuple(&hair::HelixJacobian::turns, &hair::HelixJacobian::moves);
};

template <>
struct Form<hair::HelixElement> {
  using T = hair::HelixElement;
  static constexpr auto fields = std::tuple(&T::length, &T::curvature, &T::start, &T::end, &T::at_end);
};

template <>
struct Form<hair::HelixPoint> {
  using T = hair::HelixPoint;
  static constexpr auto fields =
      std::tuple(&T::element, &T::s, &T::position, &T::moves, &T::force, &T::inertia);
};

template <>
struct Form<hair::HelixStrand> {
  using T = hair::HelixStrand;
  static constexpr auto fields =
      std::tuple(&T::lengths, &T::line_density, &T::bend_rigidity, &T::twist_rigidity, &T::natural);
  static void check(const T& strand) {
    if (strand.natural.size() != 3 * strand.lengths.size())
      throw MalformedMessage("natural coordinates of other elements");
  }
};

}  // namespace grader

namespace grader::h8 {

// Throws MalformedMessage unless all arguments have the same elements, and points are in their order.
struct OneStrand {
  static void check(const auto&... arguments) {
    Eigen::Index coordinates = -1;
    const auto expect = [&](Eigen::Index size) {
      if (coordinates < 0) coordinates = size;
      if (size < 3 || size != coordinates) throw MalformedMessage("elements of another strand, or none");
    };
    const auto look = [&]<class Argument>(const Argument& argument) {
      if constexpr (std::is_same_v<Argument, hair::HelixStrand>)
        expect(argument.natural.size());
      else if constexpr (std::is_same_v<Argument, std::vector<hair::HelixElement>>)
        expect(3 * static_cast<Eigen::Index>(argument.size()));
      else if constexpr (std::is_same_v<Argument, std::vector<hair::HelixPoint>>)
        expect_in_order(argument, coordinates / 3);
      else if constexpr (DenseNumbers<Argument>)
        if constexpr (Argument::SizeAtCompileTime == Eigen::Dynamic) expect(argument.rows());
    };
    (look(arguments), ...);
  }

 private:
  static void expect_in_order(const std::vector<hair::HelixPoint>& points, Eigen::Index elements) {
    int last = 0;
    for (const hair::HelixPoint& point : points) {
      if (point.element < last || point.element >= elements)
        throw MalformedMessage("points that are not in the order of the elements");
      last = point.element;
    }
  }
};

struct SquareMatrix {
  static void check(const auto& elements, const auto& points, const auto& matrix) {
    OneStrand::check(elements, points, matrix);
    if (matrix.cols() != matrix.rows()) throw MalformedMessage("a matrix that is not square");
  }
};

inline constexpr Contract kStep = {.scratch_columns = 10, .scratch_of_size = true};

template <auto function>
using OfOneStrand = Call<function, Contract{}, OneStrand>;

struct Calls
    : CallList<Call<hair::stumpff>, Call<hair::frame_at>, OfOneStrand<hair::carry_frames>,
               OfOneStrand<hair::helix_stiffness>, OfOneStrand<hair::elastic_force>, Call<hair::jacobian_at>,
               OfOneStrand<hair::generalised_force>, Call<hair::mass_matrix, Contract{}, SquareMatrix>,
               Call<hair::helix_step, kStep, OneStrand>> {
  static constexpr const char* id = "H8";
};

}  // namespace grader::h8
