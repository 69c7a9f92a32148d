// The table of strand models: a row holds everything that the rest of the project needs about a model. A new
// model is its name in hair/CMakeLists.txt, which makes the table; <model>_strand.cpp next to this file,
// whose function <model>_model() returns the row; a body in a folder of its own; and its exercise's contract
// in hair/.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hair/mass_spring/mass_spring_body.h"
#include "hair/simulation/description.h"
#include "hair/strand/body.h"

namespace hair {

struct ModelRow {
  const char* id;  // in scenes: "mass_spring"

  // The meaning of the numbers in a body's q, in states on disk and in replies: a number that no other model
  // has. A reader rejects a number that it does not know.
  std::uint32_t coordinates;

  // The exercises that such a strand calls, except those of its method, which it calls only if
  // `calls_method`.
  std::vector<std::string> (*exercises)(const StrandSpec& spec);

  bool calls_method;

  // The method of a scene that names none.
  Method usual_method = Method::predictor_corrector;

  // The reason why the model can't express such a strand; empty if it can.
  std::string (*why_not)(const StrandSpec& spec);

  // About how many of its points a simulation stores: memory grows with this number.
  long (*points)(const StrandSpec& spec);

  // Makes a body with the description's gravity, drag and method. Throws std::invalid_argument for a strand
  // that the model can't express.
  std::unique_ptr<Body> (*make)(const StrandSpec& spec, const Description& description);

  // True if such strands have a step for the method.
  bool (*moves_by)(const MethodRow& method);
};

std::span<const ModelRow> models();

// Null if there is none with this id.
inline const ModelRow* find_model(std::string_view id) {
  for (const ModelRow& row : models())
    if (row.id == id) return &row;
  return nullptr;
}

// Makes a strand of masses and springs with a description's method and forces. Throws std::invalid_argument
// for a start that is out of bounds (`name` is in the message).
std::unique_ptr<MassSpringBody> mass_spring_strand(const std::string& name, const StrandStart& start,
                                                   const Description& description);

}  // namespace hair
