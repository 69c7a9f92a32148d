// STAFF ONLY. Finds pairs, groups and common pieces in runs of tokens.
#include "grader/similar/shared_code.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

namespace grader::inline similar {
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

// Keeps only a file's own lines. Given runs of one file in several given texts may overlap: a line counts
// once.
void blank_given(const Sim& sim, std::vector<std::string>& texts, const std::vector<std::string>& given,
                 int least) {
  if (given.empty()) return;
  std::vector<std::set<int>> lines(texts.size());
  for (const Match& match : sim.matches(texts, given, least).all)
    for (int line = match.lines.first; line <= match.lines.last; ++line) lines[match.text].insert(line);
  for (std::size_t i = 0; i < texts.size(); ++i) texts[i] = without_lines(texts[i], lines[i]);
}

// sim's time grows with the square of a text that repeats itself, and of a quote that never ends, for each
// other text. So each file is first compared with a text that nothing resembles: honest files take
// milliseconds. Ten copies of a file take up to a hundred times as long.
constexpr std::size_t kAtOnce = 100, kCopies = 10;
constexpr int kProbeSeconds = 1, kRepeatsSeconds = 4;
constexpr const char* kProbe =
    "int f(int a) { return a + 1; }\nint g(int b) { while (b) b = b - 2; return 3 * b; }\n";

// Returns counts by text; -1 if sim does not read it in this time.
std::vector<int> tokens_of(const Sim& sim, const std::vector<std::string>& texts, int run_tokens) {
  std::vector<int> tokens;
  const auto count = [&](const std::vector<std::string>& some) {
    return sim.matches(some, {kProbe}, run_tokens, kProbeSeconds).tokens;
  };
  for (auto begin = texts.begin(); begin != texts.end();) {
    const auto end = begin + std::min<std::ptrdiff_t>(kAtOnce, texts.end() - begin);
    try {
      const std::vector<int> some = count({begin, end});
      tokens.insert(tokens.end(), some.begin(), some.end());
    } catch (const std::runtime_error&) {
      for (auto text = begin; text != end; ++text) try {
          tokens.push_back(count(std::vector(kCopies, *text)).front());
        } catch (const std::runtime_error&) {
          tokens.push_back(-1);
        }
    }
    begin = end;
  }
  return tokens;
}

// True if sim is slow with this text and a similar one, such as the same text with one more token.
bool repeats_itself(const Sim& sim, const std::string& text, int run_tokens) {
  try {
    sim.matches({text, text + "\nint\n"}, {}, run_tokens, kRepeatsSeconds);
    return false;
  } catch (const std::runtime_error&) {
    return true;
  }
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

// Reports each piece once, in the file of its first owner.
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
  std::vector<std::size_t> kept(files.size());
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  const auto texts_of = [&](const std::vector<std::size_t>& some) {
    std::vector<std::string> texts;
    for (const std::size_t file : some) texts.push_back(shared.own[file]);
    return texts;
  };
  std::vector<int> tokens(files.size());
  const auto leave_out = [&](int least) {
    const std::vector<int> sizes = tokens_of(sim, texts_of(kept), rules.run_tokens);
    std::vector<std::size_t> comparable;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const std::string has = "it has " + std::to_string(sizes[i]) + " tokens of its own, ";
      const std::string why = sizes[i] < 0                   ? "sim can't read it, or takes too long for it"
                              : sizes[i] < least             ? has + "too few to say anything"
                              : sizes[i] > rules.most_tokens ? has + "far too many"
                                                             : "";
      tokens[kept[i]] = sizes[i];
      if (why.empty())
        comparable.push_back(kept[i]);
      else
        shared.not_compared.push_back({kept[i], why, sizes[i] >= 0 && sizes[i] < least});
    }
    kept = std::move(comparable);
  };
  leave_out(0);
  std::vector<std::string> own = texts_of(kept);
  blank_given(sim, own, given, rules.given_tokens);
  for (std::size_t i = 0; i < kept.size(); ++i) shared.own[kept[i]] = std::move(own[i]);
  leave_out(rules.least_tokens);  // the blanked text may have held a comment's beginning

  std::vector<Match> all;
  const auto compare = [&](const std::vector<std::size_t>& some, const std::vector<std::size_t>& with,
                           int seconds) {
    for (Match match : sim.matches(texts_of(some), texts_of(with), rules.run_tokens, seconds).all) {
      match.text = some.at(match.text);
      match.other = (with.empty() ? some : with).at(match.other);
      all.push_back(match);
    }
  };
  const auto compare_all = [&](int seconds) {
    all.clear();
    std::vector<std::size_t> now, earlier;
    for (const std::size_t file : kept) (files[file].earlier ? earlier : now).push_back(file);
    compare(now, {}, seconds);
    if (earlier.empty() || now.empty()) return;
    compare(now, earlier, seconds);
    compare(earlier, now, seconds);
  };
  try {
    compare_all(rules.cpu_seconds / 5);
  } catch (const std::runtime_error&) {
    std::erase_if(kept, [&](std::size_t file) {
      const bool slow = repeats_itself(sim, shared.own[file], rules.run_tokens);
      if (slow)
        shared.not_compared.push_back({file, "it repeats itself so often that sim takes too long", false});
      return slow;
    });
    compare_all(rules.cpu_seconds);
  }
  const std::vector<OwnersByLine> owners = owners_by_line(all, files.size());
  shared.common = common_pieces(owners, rules.many);

  std::map<std::pair<std::size_t, std::size_t>, SharedPair> directed;
  for (const Match& match : all) {
    SharedPair& pair = directed[{match.text, match.other}];
    pair.one = match.text;
    pair.other = match.other;
    pair.tokens += match.tokens;
    if (is_of_many(owners[match.text], match.lines, rules.many)) pair.of_many += match.tokens;
    pair.blocks.push_back(match);
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

}  // namespace grader::similar
