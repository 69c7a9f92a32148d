// STAFF ONLY. Moodle's grading worksheet in any language. Titles are in the downloader's language, so columns
// are found by their place and by the form of their cells:
//
//   ID,Vollständiger Name,E-Mail-Adresse,Status,Bewertung,Bestwertung,Bewertung kann geändert werden,...
//   Teilnehmer/in 4711,Jörg Müller,j@u.de,Zur Bewertung abgegeben,"7,50","10,00",Ja,...
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/text/csv.h"

namespace grader::inline roster {

struct Worksheet {
  std::size_t identifier = 0;                       // has one word with the numbers of participants
  std::size_t name = kNoColumn, email = kNoColumn;  // a blind worksheet has none
  std::size_t grade = kNoColumn, maximum = kNoColumn, may_change = kNoColumn;
  std::vector<std::string> like_grades = {};  // are titles; `grade` is given if there is one
};

// Returns nothing if the table has another form. `grades` is the title of the grades, if it is known.
std::optional<Worksheet> worksheet_by_form(const Csv& table, const std::string& grades = "");

// True for a cell that says no, in the languages that are known here.
bool says_no(const std::string& cell);

}  // namespace grader::roster
