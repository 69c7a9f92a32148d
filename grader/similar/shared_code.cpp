// STAFF ONLY. From runs of tokens to pairs, to groups and to what many share.
#include "grader/similar/shared_code.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

namespace grader {
namespace {

using Owners = std::set<std::size_t>;
using OwnersByLine = std::map<int, Owners>;

std::string without_lines(const std::string& text, const std::set<int>& lines) {
  std::string left;
  int line = 1;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (!lines.contains(line)) left.append(text, at, end - at);
    if (end < text.size()) left += '\n';
    at = end + 1;
  }
  return left;
}

// sim ends a file at a byte 0.
std::string readable(std::string text) {
  std::replace(text.begin(), text.end(), '\0', ' ');
  return text;
}

// Leaves what a file has of its own. Given runs of one file in several given texts may overlap: a line counts once.
void blank_given(const Sim& sim, std::vector<std::string>& texts, const std::vector<std::string>& given,
                 int least) {
  if (given.empty()) return;
  std::vector<std::set<int>> lines(texts.size());
  for (const Match& match : sim.matches(texts, given, least).all)
    for (int line = match.lines.first; line <= match.lines.last; ++line) lines[match.text].insert(line);
  for (std::size_t i = 0; i < texts.size(); ++i) texts[i] = without_lines(texts[i], lines[i]);
}

// Beside an empty given text sim counts, and compares nothing. If one text stops it, each is read alone.
std::vector<int> tokens_of(const Sim& sim, const std::vector<std::string>& texts) {
  try {
    return sim.matches(texts, {""}, 1).tokens;
  } catch (const std::runtime_error&) {
    if (texts.size() == 1) return {-1};
  }
  std::vector<int> tokens;
  for (const std::string& text : texts) tokens.push_back(tokens_of(sim, {text}).front());
  return tokens;
}

std::vector<OwnersByLine> owners_by_line(const std::vector<Match>& matches, std::size_t files) {
  std::vector<OwnersByLine> owners(files);
  for (const Match& match : matches)
    for (int line = match.lines.first; line <= match.lines.last; ++line)
      owners[match.text][line].insert(match.other);
  return owners;
}

bool is_of_many(const OwnersByLine& owners, Lines lines, std::size_t many) {
  for (int line = lines.first; line <= lines.last; ++line) {
    const auto found = owners.find(line);
    if (found == owners.end() || found->second.size() + 1 < many) return false;
  }
  return true;
}

// Each piece is told once, of the first who has it.
std::vector<CommonPiece> common_pieces(const std::vector<OwnersByLine>& owners, std::size_t many) {
  std::vector<CommonPiece> pieces;
  for (std::size_t file = 0; file < owners.size(); ++file) {
    CommonPiece* open = nullptr;
    for (const auto& [line, others] : owners[file]) {
      const bool here = others.size() + 1 >= many && *others.begin() > file;
      if (here && open && open->lines.last == line - 1) {
        open->lines.last = line;
      } else if (here) {
        pieces.push_back({{line, line}, {}});
        open = &pieces.back();
      } else {
        open = nullptr;
      }
      if (!here) continue;
      Owners all(open->owners.begin(), open->owners.end());
      all.insert(file);
      all.insert(others.begin(), others.end());
      open->owners.assign(all.begin(), all.end());
    }
  }
  return pieces;
}

}  // namespace

SharedCode shared_code(const Sim& sim, const std::vector<SimilarFile>& files,
                       const std::vector<std::string>& given, const SimilarRules& rules) {
  SharedCode shared;
  for (const SimilarFile& file : files) shared.own.push_back(readable(file.text));
  blank_given(sim, shared.own, given, rules.given_tokens);

  const std::vector<int> sizes = tokens_of(sim, shared.own);
  std::vector<std::string> texts;
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const int tokens = sizes[i];
    if (tokens < 0)
      shared.not_compared.push_back({i, "sim can't read it"});
    else if (tokens < rules.least_tokens)
      shared.not_compared.push_back(
          {i, "it has " + std::to_string(tokens) + " tokens of its own, too few to say anything"});
    else if (tokens > rules.most_tokens)
      shared.not_compared.push_back(
          {i, "it has " + std::to_string(tokens) + " tokens of its own, far too many"});
    else
      texts.push_back(shared.own[i]), at.push_back(i);
  }
  Matches found = sim.matches(texts, {}, rules.run_tokens);
  for (Match& match : found.all) match.text = at.at(match.text), match.other = at.at(match.other);
  const std::vector<OwnersByLine> owners = owners_by_line(found.all, files.size());
  shared.common = common_pieces(owners, rules.many);

  std::map<std::pair<std::size_t, std::size_t>, SharedPair> directed;
  std::map<std::size_t, int> tokens;
  for (std::size_t i = 0; i < at.size(); ++i) tokens[at[i]] = found.tokens[i];
  for (const Match& match : found.all) {
    SharedPair& pair = directed[{match.text, match.other}];
    pair.one = match.text;
    pair.other = match.other;
    pair.tokens += match.tokens;
    if (is_of_many(owners[match.text], match.lines, rules.many)) pair.of_many += match.tokens;
    pair.blocks.push_back({match.lines, match.other_lines, match.tokens});
  }
  for (auto& [ends, pair] : directed) pair.part = static_cast<double>(pair.tokens) / tokens[pair.one];
  for (auto& [ends, pair] : directed) {
    const auto back = directed.find({ends.second, ends.first});
    const double other_part = back == directed.end() ? 0 : back->second.part;
    const bool larger = pair.part > other_part || (pair.part == other_part && ends.first < ends.second);
    if (larger && pair.part >= rules.least_part) shared.pairs.push_back(pair);
  }
  std::stable_sort(shared.pairs.begin(), shared.pairs.end(), [](const SharedPair& a, const SharedPair& b) {
    return a.part != b.part ? a.part > b.part : a.tokens > b.tokens;
  });
  return shared;
}

std::vector<std::vector<std::size_t>> groups_of(const SharedCode& shared, std::size_t files) {
  std::vector<std::size_t> group(files);
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (const SharedPair& pair : shared.pairs) {
    const std::size_t from = group[pair.one], to = group[pair.other];
    std::replace(group.begin(), group.end(), std::max(from, to), std::min(from, to));
  }
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < files; ++i) members[group[i]].push_back(i);
  std::vector<std::vector<std::size_t>> groups;
  for (auto& [first, all] : members)
    if (all.size() > 2) groups.push_back(std::move(all));
  return groups;
}

}  // namespace grader
