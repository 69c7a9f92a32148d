// Super-helices, as the table of models sees them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hair/strand/body.h"
#include "hair/strand/strand_spec.h"

namespace hair {

struct Description;
struct MethodRow;

// As ModelRow has them.
std::vector<std::string> super_helix_exercises(const StrandSpec& spec);
std::string super_helix_why_not(const StrandSpec& spec);
long super_helix_points(const StrandSpec& spec);
std::unique_ptr<Body> make_super_helix(const StrandSpec& spec, const Description& description);
bool super_helix_moves_by(const MethodRow& method);

}  // namespace hair
