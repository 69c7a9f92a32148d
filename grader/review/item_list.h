// STAFF ONLY. The items of a record, kept up to date for one TA: what has not changed is not read again.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "grader/record/record.h"
#include "grader/review/items.h"
#include "grader/review/sharing.h"

namespace grader::inline review {

// Another has decided an item, or its results have changed, since it was shown: nothing was saved. The text is
// a sentence for the TA.
struct ChangedMeanwhile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Functions may be called by several threads at once.
class ItemList {
 public:
  // `record` acts as `who` (Record::act_as). At the first look at a record nothing is new.
  ItemList(Record& record, std::string who);

  // Returns the present list.
  std::vector<Item> items();
  std::optional<Item> find(const std::string& key);

  // Saves what the TA does with an item, in one transaction: `change` runs for each of its people, and then
  // the item is accepted. Throws ChangedMeanwhile if the item is not as `version` says, and what `change`
  // throws; then nothing is saved. Without `change` the item is accepted as it is.
  using Change = std::function<void(Record& record, const std::string& name)>;
  void save(const std::string& key, const std::string& version, const Change& change = {});
  // Saves the same decision for all people of the item.
  void decide(const std::string& key, const std::string& version, const Decision& decision);

  // Takes back this TA's last save() or accept, with its decisions; earlier ones come back. Returns the item's
  // key, "" if there is nothing to undo. Throws ChangedMeanwhile if others have changed the same since.
  std::string undo();
  // Takes back that somebody accepted it; decisions stay.
  void reopen(const std::string& key);

  // Says that this TA has it open, and returns the other TA who has; "" if nobody has. Call it again each
  // minute or so while it is shown, with "" when none is.
  std::string open(const std::string& key);
  // Returns the key of the next undecided item of `choice` after this one that no other TA has open, from the
  // beginning after the end; "": there is none.
  std::string next(const std::string& key, const Choice& choice, bool backwards = false);

  void share(const std::vector<std::string>& graders, ShareBy by);
  std::vector<ProgressOfTa> progress();
  std::vector<const Item*> chosen(const std::vector<Item>& items, const Choice& choice);
};

}  // namespace grader::review
