// STAFF ONLY. Shares items out.
#include "grader/review/sharing.h"

#include <algorithm>
#include <set>

namespace grader::inline review {
namespace {

using Counts = std::map<std::string, std::size_t>;  // by TA

// Returns the TA who has fewest; of equal ones the first of the list.
std::string with_fewest(const std::vector<std::string>& graders, const Counts& counts) {
  return *std::ranges::min_element(graders, {}, [&](const std::string& who) { return counts.at(who); });
}

std::map<std::string, std::string> owners_of_sections(const std::vector<std::string>& graders,
                                                      const std::vector<ClassLine>& people) {
  std::map<std::string, std::set<std::string>> sections;
  for (const ClassLine& line : people)
    if (!line.section.empty()) sections[line.section].insert(line.id + "\n" + line.name);
  std::map<std::string, std::string> owners;
  Counts counts;
  for (const std::string& who : graders) counts[who] = 0;
  for (const auto& [section, members] : sections) {
    const std::string who = with_fewest(graders, counts);
    counts[who] += members.size();
    owners[section] = who;
  }
  return owners;
}

}  // namespace

std::map<RowOfItem, std::string> shared_out(const std::vector<Item>& items,
                                            const std::vector<std::string>& graders, ShareBy by,
                                            const std::vector<ClassLine>& people) {
  std::map<RowOfItem, std::string> owners;
  if (graders.empty()) return owners;
  std::map<std::string, std::string> by_person, by_section, section_of;
  if (by == ShareBy::section) by_section = owners_of_sections(graders, people);
  for (const ClassLine& line : people) section_of.emplace(line.hand_in, line.section);
  Counts counts;
  for (const std::string& who : graders) counts[who] = 0;
  const auto has_owner = [&](const Item& item) { return counts.contains(item.owner); };
  for (const Item& item : items)
    if (has_owner(item)) {
      ++counts[item.owner];
      if (!item.is_group) by_person.emplace(item.row().person, item.owner);
    }
  // Returns the owner of most people's sections; "": they have none.
  const auto owner_of_section = [&](const Item& item) {
    Counts votes;
    for (const std::string& name : item.people)
      if (const auto section = section_of.find(name); section != section_of.end())
        if (const auto owner = by_section.find(section->second); owner != by_section.end())
          ++votes[owner->second];
    const auto most = std::ranges::max_element(votes, {}, &Counts::value_type::second);
    return most == votes.end() ? std::string() : most->first;
  };
  for (const Item& item : items) {
    if (has_owner(item)) continue;
    std::string who = owner_of_section(item);
    if (const auto known = by_person.find(item.row().person); who.empty() && known != by_person.end())
      who = known->second;
    if (who.empty()) who = with_fewest(graders, counts);
    if (!item.is_group) by_person.emplace(item.row().person, who);
    ++counts[who];
    owners[item.row()] = who;
  }
  return owners;
}

std::vector<ProgressOfTa> progress(const std::vector<Item>& items, const std::map<RowOfItem, DeskRow>& rows) {
  std::map<std::string, ProgressOfTa> found;
  for (const Item& item : items) {
    ProgressOfTa& one = found[item.owner];
    ++one.items;
    one.decided += item.is_decided();
  }
  for (const auto& [row, kept] : rows)
    if (!kept.who.empty()) ++found[kept.who].has_decided;
  std::vector<ProgressOfTa> all;
  for (auto& [who, one] : found) {
    one.who = who;
    all.push_back(one);
  }
  return all;
}

std::string open_by_other(const RowOfItem& row, const std::map<RowOfItem, DeskRow>& rows,
                          const std::string& who, std::int64_t now) {
  const auto found = rows.find(row);
  if (found == rows.end() || found->second.open_by == who || now - found->second.open_at > kOpenFor.count())
    return "";
  return found->second.open_by;
}

}  // namespace grader::review
