// STAFF ONLY. The items of a record, kept up to date for one TA: results that have not changed are not read
// again. One thread at a time may use it, and several processes the record.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "grader/review/sharing.h"

namespace grader::inline review {

// Others have decided an item, or its results have changed, since it was shown: nothing was saved. The text
// is a sentence for the TA.
struct ChangedMeanwhile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class ItemList {
 public:
  // From now on the record is changed by `who`. `clock` returns seconds since 1970.
  ItemList(Record& record, std::string who, std::function<std::int64_t()> clock = seconds_now);

  std::vector<Item> items();
  std::optional<Item> find(const std::string& key);
  std::vector<ProgressOfTa> progress();
  const std::string& who() const { return who_; }

  // Saves a decision about an item, in one transaction: `change` runs for each of its people, and the item
  // is accepted. Without `change` it is accepted as it is, and a decision that it is about holds. Throws
  // ChangedMeanwhile if it is not as `version` says, and what `change` throws: then nothing is saved.
  using Change = std::function<void(Record& record, const std::string& name)>;
  void save(const std::string& key, const std::string& version, const Change& change = {});

  // Takes back this TA's last save, and returns its item's key; "": there is none in this process. Throws
  // ChangedMeanwhile if others have changed the same since.
  std::string undo();
  void reopen(const std::string& key);  // nobody has decided it any more; decisions about points stay

  // Tells others that this TA has it open, for a while (kOpenFor), and no other item; "": none. Returns the
  // other TA who has it open already; "": nobody.
  std::string open(const std::string& key);

  void share(const std::vector<std::string>& graders, ShareBy by);

 private:
  struct Saved {
    std::string key, changes;
    std::vector<std::string> people;
  };

  static std::int64_t seconds_now();
  void refresh();
  void keep_decision(const std::string& name, const Item& item);
  const Item* found(const std::string& key) const;  // null: there is none
  const Item& as_shown(const std::string& key, const std::string& version) const;

  Record& record_;
  DeskRows rows_;
  std::string who_;
  std::function<std::int64_t()> clock_;
  std::pair<std::int64_t, std::int64_t> state_{-1, -1};  // is the record's when it was read
  std::map<std::string, std::int64_t> versions_;
  ItemFacts facts_;
  std::vector<ClassLine> lines_;
  std::vector<Item> items_;
  std::vector<Saved> saved_;
};

}  // namespace grader::review
