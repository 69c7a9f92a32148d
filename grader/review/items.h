// STAFF ONLY. The list of items that a TA decides: each says why a person must look at a place of a class's
// results. It is made anew from results, decisions and requests; what people did with an item is stored
// beside it (grader/record/desk_rows.h), by a key that stays the same between calls and regrades.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/record/desk_rows.h"
#include "grader/record/points/decisions.h"
#include "grader/record/points/rules.h"
#include "grader/result/lateness.h"
#include "grader/result/result.h"
#include "grader/roster/class_list.h"

namespace grader::inline review {

// Are in the order of the list.
enum class ItemKind {
  not_taken,  // could not be taken, or a part of it
  broke_rules,
  not_final,  // ended by the clock, or points by hand are missing
  conflict,   // a decision was made when other points were computed
  request,    // a student asks for another look
  near_threshold,
  blown_up,  // numbers that are not finite, or a run that breaks off
  far_in_pictures,
  alike,   // several people lose the same categories by errors of the same size
  changed  // is new since it was last looked at
};

inline constexpr int kItemKinds = static_cast<int>(ItemKind::changed) + 1;
std::string word_of(ItemKind kind);     // "not-taken": for addresses and keys
std::string heading_of(ItemKind kind);  // "could not be taken": for people
std::optional<ItemKind> kind_from(const std::string& word);

struct Item {
  ItemKind kind = ItemKind::changed;
  std::string place;                    // tells it from others of its kind and people: "H2.3", or a size, too
  std::vector<std::string> people;      // are names of rows, sorted
  bool is_group = false;                // its key has no person: people may join and leave
  std::string exercise;                 // "H2"; "": the whole hand-in
  std::vector<std::string> categories;  // "H2.3"
  double lost = 0;                      // are points of one person in these places, the most
  std::optional<double> times;          // are the size of its largest error, in limits; may be infinite
  std::string why;                      // is a sentence
  std::string looks;                    // hashes the computed results in these places
  std::string version;                  // changes with `looks`, and with decisions and answers about it
  std::string owner;                    // is the TA whose item it is; "": nobody's
  std::string decided_by, decided_at;   // "": nobody has decided it since it looks so

  bool is_decided() const { return !decided_by.empty(); }
  RowOfItem row() const;    // its place in the record
  std::string key() const;  // is the same in an address: "near/H2.3/alice"; may hold any letter
};

// Holds a person's facts.
struct ItemPerson {
  SubmissionResult computed;  // without decisions and pictures
  std::vector<Decision> decisions = {};
  std::string handed_in = {};
};

struct Asked {  // a student's request that is open
  std::string name, place, text;
};

// Holds all that items are made of.
struct ItemFacts {
  std::map<std::string, ItemPerson> people;  // by name of the row
  std::vector<Asked> requests = {};
  HandInRules rules = {};
  std::map<RowOfItem, DeskRow> rows = {};  // say what people did with items
};

// Sorts: undecided ones first, then in the order of kinds, then more people and more lost points first. An
// item "changed" is one only if the person has been looked at before, or others have: see first_look.
std::vector<Item> items_of(const ItemFacts& facts);

// Returns the rows that say of each person's present result that it is known.
std::map<RowOfItem, std::string> first_look(const ItemFacts& facts);

// Choose from a list, and sort.
struct Choice {
  std::string text = {};  // of a name, an id or a category, in any case: all its words must occur
  std::optional<ItemKind> kind = {};
  std::string exercise = {}, section = {}, owner = {};  // "": all
  bool undecided = false;
  bool by_lost_points = false;  // else in the list's order
};
std::vector<const Item*> chosen(const std::vector<Item>& items, const Choice& choice,
                                const std::vector<ClassLine>& people);

}  // namespace grader::review
