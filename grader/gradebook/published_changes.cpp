// STAFF ONLY. Compares present totals with published ones.
#include "grader/gradebook/published_changes.h"

#include "grader/record/published.h"
#include "grader/report/facts/text.h"
#include "grader/text/csv.h"

namespace grader::inline gradebook {

PublishedChanges published_changes(Record& record) {
  PublishedChanges all{csv_line(
      {"submission", "name", "id", "e-mail", "old", "new", "category", "sentence", "published", "by"})};
  const std::vector<ClassLine> people = lines_of(record.class_list(), record.hand_ins());
  for (const std::string& name : record.names()) {
    const std::optional<Published> then = record.published(name);
    if (!then) continue;
    const Published now = published(record.find_decided(name)->result);
    const std::string sentence = change_in_words(*then, now);
    if (sentence.empty()) continue;
    ++all.students;
    const auto add = [&](const ClassLine& line) {
      all.csv +=
          csv_line({name, line.name, line.id, line.email, shown_points(then->total), shown_points(now.total),
                    changed_places(*then, now), sentence, then->at, then->by});
    };
    const std::size_t before = all.csv.size();
    for (const ClassLine& line : people)
      if (line.hand_in == name) add(line);
    if (all.csv.size() == before) add({});
  }
  return all;
}

}  // namespace grader::gradebook
