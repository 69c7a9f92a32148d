// STAFF ONLY. The tables of a record, and the steps from older versions.
#pragma once

#include <string>
#include <vector>

#include "grader/record/database.h"

namespace grader::inline record {

// Begins a statement that reads the categories of results.
inline constexpr const char* kWithCategories = R"(
WITH categories AS (
  SELECT assignment, person, json_extract(exercise.value, '$.id') || '.' || (category.key + 1) AS place,
    json_extract(exercise.value, '$.id') AS exercise, json_extract(category.value, '$.name') AS title,
    json_extract(category.value, '$.max_points') AS worth
  FROM results, json_each(result, '$.exercises') AS exercise,
    json_each(exercise.value, '$.cases') AS category)
)";

// Returns the SQL that makes version 7 of an empty file, then 8 of 7, and so on (tables/). Entries are never
// changed, only added: records have them.
const std::vector<std::string>& migrations();

// Brings the file to the last version, each step in a transaction of its own. Throws BadInput for a file of a
// newer or a far older version, and for a database that is no record.
void migrate(Database& database, const std::vector<std::string>& steps = migrations());

}  // namespace grader::record
