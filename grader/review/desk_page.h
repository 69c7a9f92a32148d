// STAFF ONLY. Writes the desk's page: the list of items, and the one that is open with what can be done.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grader/record/comments.h"
#include "grader/report/pages/pages.h"
#include "grader/review/items.h"
#include "grader/review/sharing.h"

namespace grader::inline review {

using hair::Html, hair::html;

// Holds the names of people for readers, and their sections.
struct DeskPeople {
  NamesForPeople names;
  std::map<std::string, ClassLine> lines;  // by hand-in
};

// Holds the texts beside an item. The results have people's decisions.
struct OpenItem {
  Item item;
  std::vector<SubmissionResult> results;  // the first of its people's
  std::vector<std::string> decisions;     // a line each
  std::vector<Comment> comments;          // used before
  std::string opened_by;                  // another TA who has it open, too; "": nobody
  std::string reproduce = {};             // is the command for its first category
};

std::string desk_page(const std::string& who, const std::string& where, const Html& rows, std::size_t stamp,
                      const std::vector<ProgressOfTa>& progress, const Html& item);
Html row_of(const Item& item, const DeskPeople& people);
Html item_part(const OpenItem& open, const DeskPeople& people);
Html nothing_left();
Html progress_part(const std::vector<ProgressOfTa>& progress);

}  // namespace grader::review
