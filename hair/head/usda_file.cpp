#include "hair/head/usda_file.h"

#include <charconv>
#include <span>

#include "hair/head/groom_bytes.h"

namespace hair {

namespace {

void put(std::string& text, auto number) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

// "(x, y, z)", of 32-bit numbers.
void put_triple(std::string& text, const auto& numbers, auto at) {
  text += '(';
  for (int k = 0; k < 3; ++k) {
    if (k > 0) text += ", ";
    put(text, static_cast<float>(numbers[at + k]));
  }
  text += ')';
}

// A list with a line for each of `count` items.
void put_list(std::string& text, const std::string& name, std::size_t count, auto put_item) {
  text += "    " + name + " = [\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += "        ";
    put_item(i);
    text += i + 1 < count ? ",\n" : "\n";
  }
  text += "    ]";
}

const char* const kOfEachPoint = " (\n        interpolation = \"vertex\"\n    )\n";
const char* const kOfAll = " (\n        interpolation = \"constant\"\n    )\n";

// Of each point or of all; nothing where it is not known.
void put_part(std::string& text, const std::string& name, const LookPart& part) {
  const std::span<const float> numbers = part.numbers();
  if (numbers.empty()) return;
  put_list(text, name, numbers.size() / part.size,
           [&](std::size_t i) { part.size == 3 ? put_triple(text, numbers, 3 * i) : put(text, numbers[i]); });
  text += part.of_each.empty() ? kOfAll : kOfEachPoint;
}

void put_look(std::string& text, const GroomLook& look) {
  const auto [thickness, transparency, colour] = parts_of(look);
  put_part(text, "float[] widths", thickness);
  put_part(text, "color3f[] primvars:displayColor", colour);
  std::vector<float> opacities;
  opacities.reserve(transparency.numbers().size());
  for (const float one : transparency.numbers()) opacities.push_back(1 - one);
  const bool of_each = !transparency.of_each.empty();
  put_part(text, "float[] primvars:displayOpacity",
           {"opacity", 1, of_each ? std::span<const float>() : opacities,
            of_each ? opacities : std::span<const float>()});
}

}  // namespace

std::string usda_file_of(const Groom& groom, const UsdaSettings& settings) {
  check_writable(groom, 2);
  std::string text = "#usda 1.0\n(\n    defaultPrim = \"Hair\"\n    metersPerUnit = ";
  put(text, settings.unit);
  text += std::string("\n    upAxis = \"") + (settings.z_is_up ? "Z" : "Y") + "\"\n)\n\n";
  text += "def BasisCurves \"Hair\"\n{\n";
  text += settings.cubic ? "    uniform token type = \"cubic\"\n    uniform token basis = \"catmullRom\"\n"
                           "    uniform token wrap = \"pinned\"\n"
                         : "    uniform token type = \"linear\"\n    uniform token wrap = \"nonperiodic\"\n";
  put_list(text, "int[] curveVertexCounts", groom.strands.size(),
           [&](std::size_t i) { put(text, points_of(groom.strands[i])); });
  Eigen::Vector3d low = groom.strands[0].head<3>(), high = low;
  std::size_t strand = 0;
  Eigen::Index k = 0;
  text += '\n';
  put_list(text, "point3f[] points", static_cast<std::size_t>(points_of(groom)), [&](std::size_t) {
    const Eigen::VectorXd& x = groom.strands[strand];
    low = low.cwiseMin(x.segment<3>(k));
    high = high.cwiseMax(x.segment<3>(k));
    put_triple(text, x, k);
    k += 3;
    if (k == x.size()) ++strand, k = 0;
  });
  text += '\n';
  put_look(text, groom.look);
  // Points and half of the widest hair around them, if that is known.
  float width = 0;
  for (const float one : parts_of(groom.look)[0].numbers()) width = std::max(width, one);
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(static_cast<double>(width) / 2);
  const Eigen::Matrix<double, 6, 1> box =
      (Eigen::Matrix<double, 6, 1>() << low - half, high + half).finished();
  put_list(text, "float3[] extent", 2,
           [&](std::size_t i) { put_triple(text, box, static_cast<int>(3 * i)); });
  return text + "\n}\n";
}

}  // namespace hair
