// STAFF ONLY. Reads the tables of symbols of an object, whose numbers may be anything.
#include "grader/compile/symbols.h"

#include <elf.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "grader/course/input.h"

namespace grader::inline compile {
namespace {

// Returns the struct at `at`, if it lies within the bytes.
template <class T>
std::optional<T> read_at(std::string_view bytes, std::uint64_t at) {
  if (at > bytes.size() || bytes.size() - at < sizeof(T)) return {};
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

constexpr std::size_t kMostOfAName = 100;

std::string_view part_of(std::string_view bytes, const Elf64_Shdr& section) {
  if (section.sh_offset > bytes.size()) return {};
  return bytes.substr(section.sh_offset, section.sh_size);
}

bool is_of_a_sanitizer(std::string_view name) {
  constexpr std::array<std::string_view, 8> kBegin = {"__asan_",  "__ubsan_",       "__sanitizer_",
                                                      "__lsan_",  "__tsan_",        "__interceptor_",
                                                      "___asan_", "___interceptor_"};
  return std::ranges::any_of(kBegin, [&](std::string_view begin) { return name.starts_with(begin); });
}

}  // namespace

std::optional<std::string> forbidden_definition(std::string_view object) {
  const auto header = read_at<Elf64_Ehdr>(object, 0);
  if (!header || !object.starts_with(ELFMAG) || header->e_ident[EI_CLASS] != ELFCLASS64) return {};
  const auto section = [&](std::uint64_t i) {
    return read_at<Elf64_Shdr>(object, header->e_shoff + i * sizeof(Elf64_Shdr));
  };
  // From 65280 sections on, the first one holds the number.
  const auto first = section(0);
  if (!first) return {};
  const std::uint64_t sections = header->e_shnum != 0 ? header->e_shnum : first->sh_size;
  bool seen = false;
  for (std::uint64_t i = 0; i < sections; ++i) {
    const auto table = section(i);
    if (!table) return {};
    if (table->sh_type != SHT_SYMTAB && table->sh_type != SHT_DYNSYM) continue;
    if (std::exchange(seen, true)) return "a second table of symbols";
    const auto text = section(table->sh_link);
    if (!text) return {};
    const std::string_view symbols = part_of(object, *table), names = part_of(object, *text);
    for (std::uint64_t at = 0; const auto symbol = read_at<Elf64_Sym>(symbols, at); at += sizeof(Elf64_Sym)) {
      if (symbol->st_shndx == SHN_UNDEF || symbol->st_name >= names.size()) continue;
      // Only the beginning counts: names may be long, and share their bytes.
      const std::string_view name = names.substr(symbol->st_name, kMostOfAName);
      if (is_of_a_sanitizer(name))
        return printable(name.substr(0, name.find('\0'))) +
               ", a name of the sanitizers that look for memory errors";
    }
  }
  return {};
}

}  // namespace grader::compile
