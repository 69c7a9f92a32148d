#include "hair/render/fine/hair_shading.h"

#include <algorithm>
#include <cmath>

#include "hair/render/light.h"
#include "hair/strand/variation.h"

namespace hair {
namespace {

constexpr std::uint64_t kTintSeed = 16;
const Eigen::Vector3f kFillLight = Eigen::Vector3f(0.8F, 0.15F, 0.5F).normalized();

}  // namespace

float kajiya_diffuse(const Eigen::Vector3f& tangent, const Eigen::Vector3f& light) {
  const float cosine = tangent.dot(light);
  return std::sqrt(std::max(1 - cosine * cosine, 0.0F));
}

float shifted_highlight(const Eigen::Vector3f& tangent, const Eigen::Vector3f& across,
                        const Eigen::Vector3f& half_way, float shift, float sharpness) {
  const float cosine = (tangent + shift * across).dot(half_way) / std::sqrt(1 + shift * shift);
  return std::pow(std::max(1 - cosine * cosine, 0.0F), 0.5F * sharpness);
}

StrandTint strand_tint(const StrandsDrawing& strands, std::uint32_t id) {
  Variation variation(kTintSeed, id);
  const auto tone = static_cast<float>(1 + variation.uniform(-0.28, 0.28)),
             warm = static_cast<float>(variation.uniform(-0.10, 0.10));
  const Colour own = tone * Colour(1 + warm, 1, 1 - warm);
  return {strands.root.cwiseProduct(own), strands.tip.cwiseProduct(own),
          static_cast<float>(variation.uniform(-0.05, 0.05))};
}

Colour shaded_hair(const HairPoint& point, const StrandTint& tint, const Eigen::Vector3f& up) {
  const Eigen::Vector3f eye = -point.at.normalized(), t = point.tangent;
  Eigen::Vector3f across = eye - eye.dot(t) * t;
  across /= std::max(across.norm(), 1e-6F);
  const Colour own = tint.root + point.along * (tint.tip - tint.root);

  // Light hair lets more light pass than dark hair.
  const Eigen::Array3f thick = 1.15F - 0.75F * own.array().min(1.0F).sqrt();
  const Eigen::Array3f key = point.lit * (-point.opacity * thick).exp();
  const float open = 0.12F + 0.88F * std::exp(-0.35F * point.opacity);
  const float sky = 0.65F + 0.35F * across.dot(up);
  const Eigen::Vector3f half_way = (kKeyLight + eye).normalized();

  const Eigen::Array3f body = own.array() * (0.85F * key * kajiya_diffuse(t, kKeyLight) +
                                             open * (0.18F * kajiya_diffuse(t, kFillLight) + 0.38F * sky));
  const float white = shifted_highlight(t, across, half_way, -0.12F + tint.shift, 120),
              coloured = shifted_highlight(t, across, half_way, 0.16F + tint.shift, 24);
  const Eigen::Array3f shine = key * (0.10F * white + 0.9F * coloured * own.array());
  return (body + shine).min(1.0F).matrix();
}

}  // namespace hair
