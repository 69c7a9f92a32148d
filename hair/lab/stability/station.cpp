#include "hair/lab/stability/station.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "hair/lab/stability/hanging_body.h"
#include "hair/lab/stability/theory.h"

namespace hair {

namespace {

bool keeps_lengths(const StudyMethod& method) {
  return row_of(method.method).keeps_lengths;
}

double spring_limit(const Description& hair, const StudyMethod& method, const Hanging& hanging, double drag,
                    double growth, double most) {
  const Modes &along = hanging.along_modes, &across = hanging.across_modes;
  const double gamma = hanging.drag_per_mass * drag;
  if (method.is_explicit()) {
    double least = std::numeric_limits<double>::infinity();
    for (const Modes* modes : {&along, &across})
      for (const double omega : modes->omega)
        least = std::min(least, explicit_limit(method.method, {omega, gamma}, growth));
    return least;
  }
  const ProductParts products = products_of(hair, hanging, method.geometric_term, method.bend_product);
  if (keeps_lengths(method))
    return predictor_corrector_limit(hanging.mass, across.stiffness, products.across, gamma, most, growth);
  return std::min(implicit_limit(hanging.mass, along.stiffness, products.along, gamma, growth),
                  implicit_limit(hanging.mass, across.stiffness, products.across, gamma, growth));
}

double fastest_by_tension(const Description& hair, const Hanging& hanging) {
  const ProductParts products = products_of(hair, hanging, GeometricTerm::dropped, Products::exact);
  const double limit = implicit_limit(hanging.mass, hanging.across_modes.stiffness - products.across,
                                      Eigen::MatrixXd::Zero(hanging.mass.size(), hanging.mass.size()), 0);
  return std::isfinite(limit) ? 2 / limit : hanging.across_modes.omega.maxCoeff();
}

}  // namespace

Station make_station(const Description& hair, const StudyMethod& method, double stiffness, double drag) {
  if (!hair.modelled.empty()) {
    const auto hanging = std::make_shared<const HangingBody>(hang_body(hair, stiffness));
    return {[hair, hanging, drag, disturbance = disturb(*hanging)](double h, long steps) {
              return run_disturbed(hair, *hanging, disturbance, drag, h, steps);
            },
            [hanging, drag, method](double growth, double) {
              return limit_of(method.method, *hanging, drag, growth);
            }};
  }
  const auto hanging = std::make_shared<const Hanging>(hang(hair, stiffness, keeps_lengths(method)));
  return {[hair, hanging, drag, disturbance = disturb(*hanging)](double h, long steps) {
            return run_disturbed(hair, *hanging, disturbance, drag, h, steps);
          },
          [hair, hanging, drag, method](double growth, double most) {
            return spring_limit(hair, method, *hanging, drag, growth, most);
          }};
}

MapScales map_scales(const Description& hair, const StudyMethod& method) {
  if (!hair.modelled.empty()) {
    const HangingBody hanging = hang_body(hair, 1);
    const double omega = method.is_explicit() ? hanging.fastest() : fastest_by_weight(hanging);
    return {omega, 2 * omega / hanging.drag_per_mass.maxCoeff()};
  }
  const Hanging hanging = hang(hair, 1, false);
  const double omega = method.is_explicit() ? hanging.fastest() : fastest_by_tension(hair, hanging);
  return {omega, 2 * omega / hanging.drag_per_mass};
}

}  // namespace hair
