// STAFF ONLY. Shared code on pages for staff: OUT/index.html, and OUT/S1-alice-bob.html with both sources
// side by side.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/similar/shared_code.h"

namespace grader::inline similar {

struct SimilarExercise {
  std::string id, file;  // "S1", "conj_grad.cpp"
  std::vector<SimilarFile> files;
  SharedCode shared;
};

// Throws BadInput if they can't be written.
void write_similar_pages(const std::filesystem::path& out, const std::vector<SimilarExercise>& exercises,
                         const SimilarRules& rules);

}  // namespace grader::similar
