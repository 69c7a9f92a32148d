// STAFF ONLY. Tests that names of the sanitizers are found in objects, and that hostile bytes do no harm.
#include "grader/compile/symbols.h"

#include <elf.h>
#include <gtest/gtest.h>

#include <cstring>
#include <ctime>
#include <vector>

namespace grader::inline compile {
namespace {

struct Named {
  std::string name;
  bool defined = true, local = false;
};

template <class T>
std::string bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

// Makes an object with these symbols and nothing else.
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

const std::string kWhy = ", a name of the sanitizers that look for memory errors";

TEST(Symbols, OfTheSanitizersAreFoundWhereTheyAreDefined) {
  EXPECT_EQ(forbidden_definition(object_with({{"ConjGrad"}, {"__asan_report_load8"}})),
            "__asan_report_load8" + kWhy);
  EXPECT_EQ(forbidden_definition(object_with({{"__ubsan_handle_shift_out_of_bounds", true, true}})),
            "__ubsan_handle_shift_out_of_bounds" + kWhy);
  EXPECT_EQ(forbidden_definition(object_with({{"__asan_load8", false}, {"ConjGrad"}})), std::nullopt)
      << "each object with sanitizers uses it";
  EXPECT_EQ(forbidden_definition(object_with({{"my__asan_load8"}, {"__odr_asan.table"}})), std::nullopt);
}

// A million symbols share one name of a megabyte: searching its end each time would take a minute.
TEST(Symbols, AreReadInTimeThatGrowsWithTheObject) {
  const std::size_t count = 1'000'000;
  std::string object = object_with({{std::string(1 << 20, 'a')}});
  auto* of_symbols = reinterpret_cast<Elf64_Shdr*>(object.data() + sizeof(Elf64_Ehdr) + sizeof(Elf64_Shdr));
  Elf64_Sym symbol = {};
  symbol.st_name = 1;
  symbol.st_shndx = SHN_ABS;
  of_symbols->sh_offset = object.size();
  of_symbols->sh_size = count * sizeof symbol;
  for (std::size_t i = 0; i < count; ++i) object += bytes_of(symbol);
  const std::clock_t start = std::clock();
  EXPECT_EQ(forbidden_definition(object), std::nullopt);
  EXPECT_LT(std::clock() - start, 2 * CLOCKS_PER_SEC);
}

// Many tables over the same bytes would multiply the time, and linkers choose one of them.
TEST(Symbols, StandInOneTable) {
  std::string object = object_with({{"ConjGrad"}});
  auto* sections = reinterpret_cast<Elf64_Shdr*>(object.data() + sizeof(Elf64_Ehdr));
  for (const Elf64_Word kind : {SHT_SYMTAB, SHT_DYNSYM}) {
    sections[0] = sections[1];
    sections[0].sh_type = kind;
    EXPECT_EQ(forbidden_definition(object), "a second table of symbols");
  }
}

TEST(Symbols, OfDamagedObjectsAreNone) {
  const std::string object = object_with({{"__asan_load8"}});
  for (std::size_t size = 0; size + 1 < object.size(); ++size) forbidden_definition(object.substr(0, size));
  for (std::size_t at = 0; at < object.size(); ++at)
    for (const char byte : {'\0', '\x7f', '\xff'}) {
      std::string damaged = object;
      damaged[at] = byte;
      forbidden_definition(damaged);
    }
  EXPECT_EQ(forbidden_definition(""), std::nullopt);
  EXPECT_EQ(forbidden_definition(object), "__asan_load8" + kWhy);
}

}  // namespace
}  // namespace grader::compile
