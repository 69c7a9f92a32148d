// STAFF ONLY. Gradescope's rules for results.json, for tests: the platform's own documents
// (gradescope/autograder_samples, docs/, of 2025-01-15) and our own rules.
#pragma once

#include <string>
#include <vector>

namespace grader::inline report {

// Returns each broken rule in a line, which begins with its document: "specs.md: ...", "troubleshooting.md:
// ...", or with "ours: ".
std::vector<std::string> broken_rules(const std::string& results_json);

}  // namespace grader::report
