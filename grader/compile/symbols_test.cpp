// STAFF ONLY. Objects that define a name of the sanitizers' are told, and hostile bytes break nobody.
#include "grader/compile/symbols.h"

#include <elf.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace grader {
namespace {

struct Named {
  std::string name;
  bool defined = true, local = false;
};

template <class T>
std::string bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

// An object with these symbols and nothing else.
std::string object_with(const std::vector<Named>& symbols) {
  std::string names(1, '\0'), table = bytes_of(Elf64_Sym{});
  for (const Named& one : symbols) {
    Elf64_Sym symbol = {};
    symbol.st_name = static_cast<Elf64_Word>(names.size());
    symbol.st_info = ELF64_ST_INFO(one.local ? STB_LOCAL : STB_GLOBAL, STT_NOTYPE);
    symbol.st_shndx = one.defined ? SHN_ABS : SHN_UNDEF;
    table += bytes_of(symbol);
    names += one.name + '\0';
  }
  Elf64_Ehdr header = {};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS64;
  header.e_shoff = sizeof header;
  header.e_shnum = 3;
  Elf64_Shdr none = {}, of_symbols = {}, of_names = {};
  of_symbols.sh_type = SHT_SYMTAB;
  of_symbols.sh_offset = sizeof header + 3 * sizeof none;
  of_symbols.sh_size = table.size();
  of_symbols.sh_link = 2;
  of_names.sh_type = SHT_STRTAB;
  of_names.sh_offset = of_symbols.sh_offset + table.size();
  of_names.sh_size = names.size();
  return bytes_of(header) + bytes_of(none) + bytes_of(of_symbols) + bytes_of(of_names) + table + names;
}

TEST(Symbols, OfTheSanitizersAreFoundWhereTheyAreDefined) {
  EXPECT_EQ(defined_sanitizer_symbol(object_with({{"ConjGrad"}, {"__asan_report_load8"}})),
            "__asan_report_load8");
  EXPECT_EQ(defined_sanitizer_symbol(object_with({{"__ubsan_handle_shift_out_of_bounds", true, true}})),
            "__ubsan_handle_shift_out_of_bounds");
  EXPECT_EQ(defined_sanitizer_symbol(object_with({{"__asan_load8", false}, {"ConjGrad"}})), std::nullopt)
      << "each object with sanitizers uses it";
  EXPECT_EQ(defined_sanitizer_symbol(object_with({{"my__asan_load8"}, {"__odr_asan.table"}})), std::nullopt);
}

TEST(Symbols, OfDamagedObjectsAreNone) {
  const std::string object = object_with({{"__asan_load8"}});
  for (std::size_t size = 0; size + 1 < object.size(); ++size)
    defined_sanitizer_symbol(object.substr(0, size));
  for (std::size_t at = 0; at < object.size(); ++at)
    for (const char byte : {'\0', '\x7f', '\xff'}) {
      std::string damaged = object;
      damaged[at] = byte;
      defined_sanitizer_symbol(damaged);
    }
  EXPECT_EQ(defined_sanitizer_symbol(""), std::nullopt);
  EXPECT_EQ(defined_sanitizer_symbol(object), "__asan_load8");
}

}  // namespace
}  // namespace grader
