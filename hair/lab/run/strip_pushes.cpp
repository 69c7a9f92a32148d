#include "hair/lab/run/strip_pushes.h"

#include <locale>
#include <sstream>
#include <vector>

#include "hair/linked_guides/guide_frames.h"
#include "hair/linked_guides/strip_contacts.h"

namespace hair {

std::optional<std::string> too_thick_strips(const Scene& scene) {
  if (!scene.hair.mesh || scene.hair.mesh->strips.empty()) return {};
  const ControlMesh& mesh = *scene.hair.mesh;
  std::vector<int> first{0};
  for (const StrandStart& start : scene.hair.strands) first.push_back(first.back() + start.strand.count());
  Eigen::VectorXd x(3 * Eigen::Index{first.back()}), tangents(x.size());
  for (std::size_t i = 0; i < scene.hair.strands.size(); ++i) {
    const Eigen::VectorXd& of_strand = scene.hair.strands[i].state.x;
    x.segment(3 * Eigen::Index{first[i]}, of_strand.size()) = of_strand;
    guide_tangents(of_strand, tangents.segment(3 * Eigen::Index{first[i]}, of_strand.size()));
  }
  StripContacts contacts(mesh, first);
  contacts.find(x, tangents);
  const std::size_t pushes = contacts.all().size();
  if (pushes <= static_cast<std::size_t>(first.back())) return {};
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "warning: strips " << mesh.law.thickness << " m thick push " << first.back() << " particles at "
       << pushes
       << " places before anything moves, and a frame may take seconds; \"thickness\" should be less than "
          "the distance "
          "between hairs";
  return text.str();
}

}  // namespace hair
