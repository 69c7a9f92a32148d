// The table of strand models: a row has all that the rest of the project knows of a model. A new one is a row here, a body
// in a room of its own, and its exercise's contract in hair/.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hair/simulation/description.h"
#include "hair/strand/body.h"

namespace hair {

struct ModelRow {
  const char* id;  // in scenes: "mass_spring"

  // The exercises that such a strand calls, those of its method aside.
  std::vector<std::string> (*exercises)(const StrandSpec& spec);

  // Why it can't express such a strand; empty if it can.
  std::string (*why_not)(const StrandSpec& spec);

  // A body with what the description asks for: gravity, drag, its method. Throws std::invalid_argument for a strand that
  // the model can't express, and for an exercise that the course leaves out.
  std::unique_ptr<Body> (*make)(const StrandSpec& spec, const Description& description);
};

std::span<const ModelRow> models();
const ModelRow* find_model(std::string_view id);  // null: there is none of this name

}  // namespace hair
