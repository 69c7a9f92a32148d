#include <numbers>
#include <string>

#include "hair/lab/validate/elastica.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

// Half of the last printed digit.
constexpr double kSixDigits = 0.5e-6, kSevenDigits = 0.5e-7;

void add(ValidationResult& result, const std::string& id, const std::string& shows, const std::string& source,
         double published, double computed, double tolerance) {
  result.checks.push_back(
      {id, shows, source, published, computed, tolerance, "half of the last digit that is printed"});
}

}  // namespace

ValidationResult published_numbers(const ValidationSettings&) {
  ValidationResult result;
  const std::string laguerre = "Abramowitz and Stegun, table 25.9";
  add(result, "laguerre-2", "the smallest zero of L_2", laguerre, 0.585786, laguerre_zeros(2)[0], kSixDigits);
  add(result, "laguerre-10", "the smallest zero of L_10", laguerre, 0.137793, laguerre_zeros(10)[0],
      kSixDigits);
  add(result, "laguerre-20", "the smallest zero of L_20", "NIST DLMF, 3.5(v)", 0.0705399,
      laguerre_zeros(20)[0], kSevenDigits);
  const struct {
    int degrees;
    double ratio;
  } periods[] = {{30, 1.017409}, {60, 1.073182}, {90, 1.180341}, {150, 1.762204}, {170, 2.439363}};
  for (const auto& [degrees, ratio] : periods)
    add(result, "pendulum-" + std::to_string(degrees),
        "a pendulum out to " + std::to_string(degrees) + " degrees: T/T0",
        "2/pi K(sin(angle/2)): Abramowitz and Stegun, table 17.2", ratio,
        period_ratio(degrees * std::numbers::pi / 180), kSixDigits);
  const struct {
    double gamma, width, drop;
  } tips[] = {{1, 0.991246, 0.123471}, {10, 0.656354, 0.700200}, {100, 0.159223, 0.937524}};
  for (const auto& [gamma, width, drop] : tips) {
    const Elastica curve = elastica(gamma);
    const std::string id = "elastica-" + to_text(gamma),
                      shows = "hair clamped level, Gamma = " + to_text(gamma);
    add(result, id + "-width", shows + ": the tip's x / L", "the assignment's numbers", width, curve.tip[0],
        kSixDigits + curve.error);
    add(result, id + "-drop", shows + ": the tip's drop / L", "the assignment's numbers", drop, curve.tip[1],
        kSixDigits + curve.error);
  }
  return result;
}

}  // namespace hair
