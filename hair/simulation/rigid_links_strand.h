// Strands of rigid links, as the tables of models and of methods see them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hair/strand/body.h"
#include "hair/strand/strand_spec.h"

namespace hair {

struct Description;
struct LinkStrand;
struct MethodRow;

// The step that a method is for such strands: a member of TreeSteps (hair/rigid_links/tree_steps.h).
struct LinkMethod;
extern const LinkMethod kLinkSymplecticEuler, kLinkRungeKutta4, kLinkImplicitEuler;

// As ModelRow has them.
std::vector<std::string> rigid_links_exercises(const StrandSpec& spec);
std::string rigid_links_why_not(const StrandSpec& spec);
std::unique_ptr<Body> make_rigid_links(const StrandSpec& spec, const Description& description);
LinkStrand links_of(const StrandSpec& spec, const Description& description);  // with weight and drag
bool rigid_links_moves_by(const MethodRow& method);

}  // namespace hair
