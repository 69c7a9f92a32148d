// STAFF ONLY. The list of items that a TA decides: each says why a person must look at a place of a class's
// results. It is made anew from results, decisions and requests. What people did with an item is stored
// beside it (grader/record/desk_rows.h), under a key that stays the same between calls and regrades; an item
// that looks otherwise than when it was accepted is undecided again.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/record/desk_rows.h"

namespace grader::inline review {

// These are in the order of the list.
enum class ItemKind {
  not_taken,  // could not be taken, or a part of it
  broke_rules,
  not_final,       // ended by the clock
  conflict,        // a decision was made when other points were computed
  request,         // a student asks for another look
  near_threshold,  // an error near its limit, all but one of the cases, or late by less than an hour
  blown_up,        // numbers that are not finite, or a run that breaks off
  far_in_pictures,
  alike,   // several people lose the same categories by errors of the same size
  changed  // is new since it was last looked at
};

inline constexpr int kItemKinds = static_cast<int>(ItemKind::changed) + 1;
std::string word_of(ItemKind kind);     // "not-taken": for keys and addresses
std::string heading_of(ItemKind kind);  // "could not be taken": for people

struct Item {
  ItemKind kind = ItemKind::changed;
  std::string place = {};                        // tells it from others of its kind and people: "H2.3"
  std::vector<std::string> people = {};          // are names of rows, sorted
  bool is_group = false;                         // true: its key has no person, as people may join and leave
  std::string exercise = {};                     // "H2"; "": the whole hand-in
  std::vector<std::string> categories = {};      // "H2.3"
  double lost = 0;                               // is the most that one person has lost here
  std::string why = {};                          // is a sentence
  std::string titles = {};                       // are the exercise's and the categories', for the search
  std::string looks = {};                        // hashes the computed results here
  std::string version = {};                      // changes with these, and with decisions about them
  std::string owner = {};                        // is the TA whose item it is; "": nobody's
  std::string decided_by = {}, decided_at = {};  // "": nobody has since it looks so

  bool is_decided() const { return !decided_by.empty(); }
  RowOfItem row() const;
  std::string key() const;  // "near-threshold/H2/alice"; may hold any letter of a name
};

struct ItemPerson {
  SubmissionResult computed;  // without decisions and pictures
  std::vector<Decision> decisions = {};
  std::string handed_in = {};
};

struct ItemFacts {
  std::map<std::string, ItemPerson> people;  // by the name of the row
  std::vector<Request> requests = {};
  HandInRules rules = {};
  std::map<RowOfItem, DeskRow> rows = {};
};

// Sorts undecided ones first, then by kind, then those of most people and most lost points first. A person is
// new only in a class that has had its first look.
std::vector<Item> items_of(const ItemFacts& facts);

// Returns the rows that make each person's present result a known one; nothing if the class has had this.
std::map<RowOfItem, std::string> first_look(const ItemFacts& facts);

inline constexpr const char* kLate = "late";  // is the place of an item about less than an hour

// Returns the place of an item about decisions of a kind, such as "points", at a place.
std::string place_of_conflict(const std::string& place, const std::string& kind);

}  // namespace grader::review
