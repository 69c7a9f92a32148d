// STAFF ONLY. Cleans the paths of entries.
#include "grader/intake/archives/container.h"

#include <utf8proc.h>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grader/intake/names/names.h"
#include "grader/text/encoding.h"
#include "grader/text/letters.h"

namespace grader::inline intake {

namespace {

bool is_latin(utf8proc_int32_t c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_accented(utf8proc_int32_t c) {
  return c >= 0xc0 && c <= 0x17f && c != 0xd7 && c != 0xf7;
}

bool is_capital(utf8proc_int32_t c) {
  return (c >= 'A' && c <= 'Z') || (c >= 0xc0 && c <= 0xde);
}

bool is_east_asian(utf8proc_int32_t c) {
  return (c >= 0x3041 && c <= 0x30fe) || (c >= 0x4e00 && c <= 0x9fff);
}

// Rates how much a text looks like a name: accented letters stand among Latin ones, ideograms together.
double likeness(std::string_view text) {
  double sum = 0;
  utf8proc_int32_t before = ' ';
  while (!text.empty()) {
    utf8proc_int32_t c = 0, after = ' ';
    const auto at = [&](std::size_t from, utf8proc_int32_t* letter) {
      return utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()) + from,
                              static_cast<utf8proc_ssize_t>(text.size() - from), letter);
    };
    const auto size = static_cast<std::size_t>(at(0, &c));
    if (size < text.size()) at(size, &after);
    text.remove_prefix(size);
    if (c >= 0x80) {
      const bool in_a_word = is_latin(before) || is_latin(after);
      if (is_accented(c)) {
        sum += in_a_word ? 1 : -0.5;
        if (is_capital(c) && is_latin(before) && !is_capital(before)) sum -= 1.5;
      } else if (is_east_asian(c)) {
        sum += in_a_word ? -2 : 1.5;
      } else {
        sum -= 2;
      }
    }
    before = c;
  }
  return sum;
}

// No archive names its code page reliably: zip has a flag, which some programs set for any bytes, and others
// never. So it is guessed from all names of an archive together, and the guess is reported.
//
// Changes names into UTF-8 and returns their code page ("GB18030"); "" if all were UTF-8 already. It always
// finds one.
std::string decode_names(std::vector<std::string>& names) {
  std::vector<std::string*> unknown;
  for (std::string& name : names)
    if (!is_utf8(name)) unknown.push_back(&name);
  if (unknown.empty()) return {};
  // The last code page takes any bytes.
  constexpr std::array<const char*, 5> kPages{"CP1252", "CP437", "GB18030", "SHIFT_JIS", "ISO-8859-1"};
  std::string best;
  double best_sum = 0;
  std::vector<std::string> best_names;
  for (const char* page : kPages) {
    double sum = 0;
    std::vector<std::string> decoded;
    for (const std::string* name : unknown) {
      std::optional<std::string> text = from_code_page(*name, page);
      if (!text) break;
      sum += likeness(*text);
      decoded.push_back(std::move(*text));
    }
    if (decoded.size() < unknown.size() || (!best.empty() && sum <= best_sum)) continue;
    best = page;
    best_sum = sum;
    best_names = std::move(decoded);
  }
  if (best.empty()) {  // the system has none of these tables
    best = "ISO-8859-1";
    for (const std::string* name : unknown) {
      std::string& text = best_names.emplace_back();
      for (const char c : *name) {
        utf8proc_uint8_t letter[4];
        const auto size = utf8proc_encode_char(static_cast<unsigned char>(c), letter);
        text.append(reinterpret_cast<const char*>(letter), static_cast<std::size_t>(size));
      }
    }
  }
  for (std::size_t i = 0; i < unknown.size(); ++i) *unknown[i] = std::move(best_names[i]);
  return best;
}

}  // namespace

Entry entry_at(std::string shown) {
  Entry entry;
  entry.lost_root = !shown.empty() && (shown.front() == '/' || shown.front() == '\\');
  std::vector<std::string_view> parts;
  std::string_view rest = shown;
  while (!rest.empty()) {
    const std::size_t end = rest.find_first_of("/\\");
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    const bool drive = parts.empty() && part.size() == 2 && part[1] == ':';
    if (drive || (part == ".." && parts.empty())) {
      entry.lost_root = true;
    } else if (part == "..") {
      entry.leads_outside = true;
    } else if (!part.empty() && part != ".") {
      parts.push_back(part);
    }
  }
  const bool of_all_users = parts.size() > 2 && (parts[0] == "Users" || parts[0] == "home");
  for (std::size_t i = entry.lost_root && of_all_users ? 1 : 0; i < parts.size(); ++i)
    entry.path += (entry.path.empty() ? "" : "/") + std::string(parts[i]);
  entry.shown = std::move(shown);
  return entry;
}

namespace {

// Replaces each part of the path that is too long for file systems, or takes more than linear time to
// compose, by a number.
std::string within_limits(std::string_view path) {
  constexpr std::size_t kLongestPart = 255;
  std::string result;
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find_first_of("/\\"));
    result += part.size() <= kLongestPart && is_stream_safe(part) ? part : name_among_equals("name", part);
    path.remove_prefix(part.size());
    result += path.substr(0, 1);
    path.remove_prefix(std::min<std::size_t>(path.size(), 1));
  }
  return result;
}

}  // namespace

std::vector<std::string> settle_names(std::vector<Entry>& list, const std::string& shown) {
  std::vector<std::string> names, said;
  for (const Entry& entry : list) names.push_back(entry.shown);
  if (const std::string page = decode_names(names); !page.empty())
    said.push_back(shown + ": names in it are no UTF-8; they were read as " + page + ", which is a guess");
  const Entry *first_root = nullptr, *first_refused = nullptr;
  std::size_t roots = 0, refused = 0;
  std::map<std::string_view, Entry*> last;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string limited = within_limits(names[i]);
    const Entry named = entry_at(composed_path(limited));
    Entry& entry = list[i];
    if (limited != names[i] && refused++ == 0) first_refused = &entry;
    entry.shown = named.shown;
    entry.path = named.path;
    entry.leads_outside = named.leads_outside;
    entry.lost_root = named.lost_root;
    if (entry.kind == Entry::Kind::folder) continue;
    if (entry.path.empty()) entry.path = entry.shown = "entry " + std::to_string(i + 1);
    if (entry.lost_root && roots++ == 0) first_root = &entry;
    Entry*& latest = last[entry.path];
    if (latest) latest->replaced = true;
    latest = &entry;
  }
  const auto and_more = [](std::size_t count) {
    return count > 1 ? ", as in " + std::to_string(count - 1) + " more" : "";
  };
  if (refused > 0)
    said.push_back(shown +
                   ": a name of more than 255 bytes, or with more than 30 marks in a row, is refused: " +
                   legible(first_refused->shown) + " stands for it" + and_more(refused));
  if (roots > 0)
    said.push_back(shown + ": " + legible(first_root->shown) + " begins at a root, which was left away" +
                   and_more(roots));
  return said;
}

std::string_view name_of(const Entry& entry) {
  const std::string_view path = entry.path;
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string shown_size(std::uintmax_t bytes) {
  constexpr std::uintmax_t mebibyte = 1 << 20;
  if (bytes >= mebibyte) return std::to_string(bytes / mebibyte) + " MiB";
  return std::to_string(bytes) + " bytes";
}

}  // namespace grader::intake
