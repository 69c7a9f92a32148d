#include "hair/linked_guides/linked_guides.h"

#include <algorithm>
#include <utility>

#include "hair/linked_guides/frame_torque.h"
#include "particles/implicit_euler.h"
#include "particles/require.h"

namespace hair {
namespace {

using particles::require, particles::require_at_least, particles::require_finite, particles::require_positive;

void check_mesh(const ControlMesh& mesh, int guides, int particles) {
  const auto check = [](const char* what, int index, int count) {
    require(index >= 0 && index < count, what, index, "at least 0 and less than " + std::to_string(count));
  };
  for (const StaticLink& link : mesh.links) {
    check("a link's particle", link.a, particles);
    check("a link's particle", link.b, particles);
    require(link.a != link.b, "both ends of a link", link.a, "two particles");
    require_finite("a link's offset", link.offset);
    require_positive("a link's length", link.length);
    require_at_least("a link's stiffness", link.stiffness, 0);
    require_at_least("the stretch at which a link yields", link.yields, 0);
    require_at_least("the stretch at which a link breaks", link.breaks, link.yields);
  }
  for (const MeshStrip& strip : mesh.strips) {
    for (const int guide : strip.guides) check("a strip's guide", guide, guides);
    for (const auto& triangle : strip.triangles)
      for (const int corner : triangle) check("a corner of a strip", corner, particles);
  }
  if (mesh.strips.empty()) return;
  require_positive("the thickness of strips", mesh.law.thickness);
  require_at_least("the stiffness of strips", mesh.law.stiffness, 0);
  require_at_least("the friction of strips", mesh.law.friction, 0);
}

// All guides are watched, or none: they are made alike.
std::optional<LinkedEnergy> books_of(const std::vector<MassSpringBody*>& strands) {
  std::vector<const EnergyWatch*> watches;
  for (const MassSpringBody* strand : strands)
    if (strand->energy_watch()) watches.push_back(strand->energy_watch());
  if (watches.empty()) return {};
  return LinkedEnergy(std::move(watches));
}

std::vector<int> first_particles(const std::vector<MassSpringBody*>& strands) {
  std::vector<int> first{0};
  for (const MassSpringBody* strand : strands) first.push_back(first.back() + strand->points());
  return first;
}

// The roots of the guides of all links' particles a; 0 for a particle that check_mesh refuses.
std::vector<int> roots_of(const ControlMesh& mesh, const std::vector<int>& first) {
  std::vector<int> roots;
  for (const StaticLink& link : mesh.links) {
    const auto next = std::upper_bound(first.begin(), first.end(), link.a);
    roots.push_back(next == first.begin() ? 0 : *(next - 1));
  }
  return roots;
}

}  // namespace

const StepMethod kLinkedImplicitEuler{
    .step = kImplicitEuler.step, .scratch = particles::kImplicitScratch, .goes_straight_on = true};

LinkedGuides::LinkedGuides(std::vector<MassSpringBody*> strands, const ControlMesh& mesh, bool watched)
    : strands_(std::move(strands)),
      first_(first_particles(strands_)),
      mesh_(mesh),
      watched_(watched),
      books_(books_of(strands_)),
      force_(mesh_, held_, roots_of(mesh_, first_)),
      contacts_(mesh_, first_) {
  const Eigen::Index count = first_.back(), size = 3 * count;
  check_mesh(mesh_, static_cast<int>(strands_.size()), first_.back());
  particles_.mass.resize(count);
  inverse_mass_.resize(count);
  for (std::size_t i = 0; i < strands_.size(); ++i) {
    const MovingStrand& moving = strands_[i]->moving();
    require(moving.strand.clamped, "strand " + std::to_string(i) + " of a control mesh, clamped:", 0, "1");
    particles_.mass.segment(first_[i], moving.strand.count()) = moving.particles.mass;
    particles_.pinned.insert(particles_.pinned.end(), moving.particles.pinned.begin(),
                             moving.particles.pinned.end());
    force_.add_strand(moving.force, strands_[i]->size());
  }
  for (int i = 0; i < first_.back(); ++i)
    inverse_mass_[i] = particles_.is_pinned(i) ? 0 : 1 / particles_.mass[i];
  state_ = {Eigen::VectorXd(size), Eigen::VectorXd(size)};
  held_.frames.resize(static_cast<std::size_t>(count));
  tangents_.setZero(mesh_.strips.empty() ? 0 : size);
  scratch_.setZero(size, particles::kImplicitScratch);
  before_.setZero(static_cast<Eigen::Index>(mesh_.links.size()));
  mesh_force_.setZero(books_ ? size : 0);
  record_.broken.reserve(mesh_.links.size());
  restart();
}

void LinkedGuides::restart() {
  held_.largest.setZero(static_cast<Eigen::Index>(mesh_.links.size()));
  contacts_.forget();
  held_.contacts = {};
  record_.broken.clear();
  record_.worn_off = 0;
  if (books_) books_->restart();
  steps_ = 0;
}

double LinkedGuides::energy(particles::Input x) const {
  std::vector<Matrix3d> frames(held_.frames.size());
  for (std::size_t i = 0; i < strands_.size(); ++i) add_frames(i, x, frames);
  return link_energy(mesh_.links, frames, held_.largest, x) + strip_energy(held_.contacts, mesh_.law, x);
}

void LinkedGuides::step(const BodyStep& step, std::span<std::optional<Stage>> broke, Work& work) {
  ++steps_;
  gather();
  if (!mesh_.strips.empty()) touch(step.h);
  force_.hold();
  MeshEnergies energies;
  if (books_) energies = {.links_before = links_hold(), .strips_before = strips_hold()};
  const particles::SolveReport report =
      particles::implicit_euler(force_, particles_, step.h, step.tolerance, state_, scratch_);
  const StepOutcome outcome = outcome_of(report);
  if (books_) energies.root_work = root_work(step.h);
  const long contacts = work.contacts;
  bool sound = true;
  for (std::size_t i = 0; i < strands_.size(); ++i) {
    // The solve is counted once.
    const StepOutcome of_strand = i == 0 ? outcome : StepOutcome{.suspect = Stage::filter};
    broke[i] = strands_[i]->step_to(step, part(state_.x, i), part(state_.v, i), of_strand, work);
    sound = sound && !broke[i];
  }
  if (!sound) return;
  gather();
  if (books_) {
    energies.links_after = links_hold();
    energies.strips_after = strips_hold();
    energies.contacts = !held_.contacts.empty() || work.contacts > contacts;
    books_->after_step(energies);
  }
  remember();
}

Eigen::VectorBlock<Eigen::VectorXd> LinkedGuides::part(Eigen::VectorXd& all, std::size_t strand) const {
  return all.segment(3 * Eigen::Index{first_[strand]}, strands_[strand]->size());
}

// The strands' states, and the frames that go with them.
void LinkedGuides::gather() {
  for (std::size_t i = 0; i < strands_.size(); ++i) {
    strands_[i]->read(part(state_.x, i), part(state_.v, i));
    add_frames(i, state_.x, held_.frames);
  }
}

void LinkedGuides::add_frames(std::size_t i, particles::Input x, std::span<Matrix3d> frames) const {
  const MassSpringBody& strand = *strands_[i];
  guide_frames(
      x.segment(3 * Eigen::Index{first_[i]}, strand.size()), strand.moving().strand.root_tangent,
      strand.root_normal(),
      frames.subspan(static_cast<std::size_t>(first_[i]), static_cast<std::size_t>(strand.points())));
}

double LinkedGuides::links_hold() const {
  return link_energy(mesh_.links, held_.frames, held_.largest, state_.x);
}
double LinkedGuides::strips_hold() const {
  return strip_energy(held_.contacts, mesh_.law, state_.x);
}

// See LinkedEnergy. Called at the end of a solve.
double LinkedGuides::root_work(double h) {
  mesh_force_.setZero();
  force_.add_mesh_force(state_.x, mesh_force_);
  double work = 0;
  for (std::size_t i = 0; i < strands_.size(); ++i) {
    const Vector3d force = part(mesh_force_, i).reshaped(3, strands_[i]->points()).rowwise().sum();
    work -= h * force.dot(part(state_.v, i).head<3>());
  }
  return work;
}

// Reads a link's energy only if the link has just become weaker.
void LinkedGuides::remember() {
  before_ = held_.largest;
  remember_stretches(mesh_.links, held_.frames, state_.x, held_.largest);
  const std::span<const StaticLink> links = mesh_.links;
  for (std::size_t l = 0; l < links.size(); ++l) {
    const auto at = static_cast<Eigen::Index>(l);
    const double stretch = held_.largest[at], before = before_[at];
    if (!(stretch > before) || stretch <= links[l].yields) continue;
    if (stretch >= links[l].breaks && before < links[l].breaks)
      record_.broken.push_back({steps_, static_cast<int>(l)});
    if (!watched_ || before >= links[l].breaks) continue;
    const auto energy_at = [&](const Eigen::VectorXd& largest) {
      return link_energy(links.subspan(l, 1), held_.frames, largest.segment(at, 1), state_.x);
    };
    record_.worn_off += energy_at(before_) - energy_at(held_.largest);
  }
}

void LinkedGuides::touch(double h) {
  for (std::size_t i = 0; i < strands_.size(); ++i) guide_tangents(part(state_.x, i), part(tangents_, i));
  contacts_.find(state_.x, tangents_);
  held_.contacts = contacts_.all();
  apply_strip_friction(held_.contacts, mesh_.law, inverse_mass_, h, state_.x, state_.v);
}

void LinkedEnergy::restart() {
  *this = LinkedEnergy(std::move(guides_));
}

void LinkedEnergy::after_step(const MeshEnergies& mesh) {
  if (!begun_) {
    begun_ = true;
    links_ = mesh.links_before;
    strips_ = mesh.strips_before;
    scale_ = links_ + strips_;
  }
  const bool touched = mesh.contacts || strips_ > 0;
  scale_ += std::max(mesh.links_before - links_, 0.0) + std::max(mesh.root_work, 0.0);
  double gained = mesh.links_after - mesh.links_before + mesh.strips_after - strips_ - mesh.root_work;
  links_ = mesh.links_after;
  strips_ = mesh.strips_after;

  double scale = scale_;
  for (const EnergyWatch* guide : guides_) {
    gained += guide->last();
    scale += guide->scale();
  }
  (touched ? in_contact_ : free_).add(gained);
  gain_ = std::max(gain_, free_.risen() / scale);
  contact_gain_ = std::max(contact_gain_, in_contact_.risen() / scale);
  loss_ = std::max(loss_, free_.fallen() / scale);
}

}  // namespace hair
