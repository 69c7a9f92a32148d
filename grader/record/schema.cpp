// STAFF ONLY. Makes the tables of a record (tables/).
#include "grader/record/schema.h"

#include <algorithm>
#include <iterator>

#include "grader/course/input.h"
#include "grader/record/tables.h"

namespace grader::inline record {
namespace {

constexpr std::int64_t kApplication = 0x68616972;  // "hair"
constexpr std::int64_t kBaseVersion = 7;           // is that of an empty file's first tables

}  // namespace

const std::vector<std::string>& migrations() {
  static const std::vector<std::string> all(std::begin(kTables), std::end(kTables));
  return all;
}

void migrate(Database& database, const std::vector<std::string>& steps) {
  const auto version = [&] { return database.number("PRAGMA user_version"); };
  const std::string where = printable(database.file().string(), 4096);
  // One statement sees one state of the file, whoever makes it at this moment.
  if (database.number("SELECT application_id <> ? AND (application_id <> 0 OR (SELECT count(*) FROM "
                      "sqlite_master) <> 0) FROM pragma_application_id",
                      {kApplication}) != 0)
    throw BadInput(where + ": is a database, but no record of grades; name another folder with --out");
  const auto last = kBaseVersion - 1 + static_cast<std::int64_t>(steps.size());
  const std::int64_t found = version();
  if (found > last || (found > 0 && found < kBaseVersion))
    throw BadInput(where + ": has version " + std::to_string(found) + ", and this hairgrade knows " +
                   std::to_string(kBaseVersion) + " to " + std::to_string(last) +
                   "; use the hairgrade that made it");
  while (version() < last) {
    Transaction transaction(database);
    const std::int64_t next = std::max(kBaseVersion, version() + 1);  // another process may have migrated it
    if (next > last) return;
    database.run_all(steps[static_cast<std::size_t>(next - kBaseVersion)]);
    database.run("INSERT INTO migrations VALUES (?, strftime('%Y-%m-%d %H:%M:%S', 'now'))", {next});
    database.run_all("PRAGMA application_id = " + std::to_string(kApplication) +
                     "; PRAGMA user_version = " + std::to_string(next) + ";");
    transaction.commit();
  }
}

}  // namespace grader::record
