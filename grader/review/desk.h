// STAFF ONLY. Answers the requests of the desk's page, with which a TA decides items. A decision is in the
// record before its answer is sent.
//
//   GET               the page; class/... are the pages of the class, made from the record
//   GET item/N/KEY    an item, and the rows of the list that changed since the page's stamp N
//   GET news/N/KEY    these rows alone; it says that the TA has this item open
//   POST save         JSON of what is decided; the answer has the next item
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "grader/review/desk_page.h"
#include "grader/review/item_list.h"
#include "hair/io/serve/local_server.h"

namespace grader::inline review {

inline constexpr std::size_t kMostSavedBytes = 64 << 10;

class Desk {
 public:
  // `where` names the class for readers. The record must outlive the desk, and acts as `who`.
  Desk(Record& record, std::string who, std::string where);

  ItemList& list() { return list_; }
  hair::WebAnswer answer(const hair::WebRequest& request);

 private:
  struct Row {
    std::string html;  // "": it is gone
    std::size_t stamp = 0;
  };
  struct Shown {  // is what an answer shows
    std::string key, told;
    unsigned status = 200;
    bool with_item = true;
  };

  void refresh();
  std::string page();
  hair::WebAnswer shown(const Shown& what, std::size_t since);
  hair::WebAnswer save(const std::string& body);
  hair::WebAnswer page_of_class(const std::string& path);
  std::string first_of(const std::vector<std::string>& keys);
  Html part(const std::string& key);

  Record& record_;
  std::string who_, where_;
  ItemList list_;
  std::mutex one_at_a_time_;
  DeskPeople people_;
  std::vector<Item> items_;
  std::map<std::string, Row> rows_;
  std::size_t stamp_ = 0;
};

}  // namespace grader::review
