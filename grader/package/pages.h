// STAFF ONLY. The handout's pages: each text, Markdown, also as HTML that a browser shows without a network.
#pragma once

#include <filesystem>
#include <string>

#include "grader/package/gates.h"

namespace grader::inline package {

// Adds the paths of the texts' pages, and of their font's licence.
Paths with_pages(Paths paths);

// Adds the pages, and a first line to the README that leads to its own; or says in a sentence which program
// is missing. `script` makes them. Throws BadInput for a text that can't become a page.
std::string add_pages(Files& handout, const std::filesystem::path& script);

}  // namespace grader::package
