#include "hair/lab/run/states_file.h"

#include <bit>
#include <charconv>
#include <utility>

namespace hair {

namespace {

static_assert(std::endian::native == std::endian::little, "files are written as memory is");

constexpr std::string_view kMagic = "HAIRRUN1", kLinksMagic = "BROKEN 1";
constexpr std::uint64_t kFramesAt = 16;  // bytes

template <class Number>
std::string_view memory_of(const Number& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string_view memory_of(const Eigen::VectorXd& values) {
  return {reinterpret_cast<const char*>(values.data()),
          sizeof(double) * static_cast<std::size_t>(values.size())};
}

// Adds a field of a line of CSV, and a comma.
template <class Number>
void add_field(std::string& line, Number number) {
  std::array<char, 32> digits{};
  line.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr) += ',';
}

}  // namespace

StatesWriter::StatesWriter(const std::filesystem::path& file, const std::filesystem::path& shown,
                           const std::vector<int>& strands, int particles, std::uint32_t coordinates)
    : file_(file, shown) {
  file_.write(kMagic);
  for (const std::uint32_t number :
       {static_cast<std::uint32_t>(strands.size()), static_cast<std::uint32_t>(particles), 0U, coordinates})
    file_.write(memory_of(number));
  for (const int size : strands) file_.write(memory_of(static_cast<std::uint32_t>(size)));
  file_.write(std::string(strands.size() % 2 * 4, '\0'));
}

void StatesWriter::add(double time, const particles::State& state) {
  file_.write(memory_of(time));
  file_.write(memory_of(state.x));
  file_.write(memory_of(state.v));
  ++frames_;
}

void StatesWriter::add(const LinksFile& links) {
  file_.write(kLinksMagic);
  for (const std::size_t count : {links.particles.size(), links.broken.size()})
    file_.write(memory_of(static_cast<std::uint32_t>(count)));
  for (const auto& ends : links.particles)
    for (const int particle : ends) file_.write(memory_of(static_cast<std::uint32_t>(particle)));
  for (const BrokenLink& one : links.broken) {
    file_.write(memory_of(static_cast<std::uint64_t>(one.step)));
    file_.write(memory_of(static_cast<std::uint64_t>(one.link)));
  }
}

void StatesWriter::close() {
  file_.overwrite(kFramesAt, memory_of(frames_));
  file_.close();
}

CsvWriter::CsvWriter(const std::filesystem::path& file, const std::filesystem::path& shown,
                     std::vector<int> strands)
    : file_(file, shown), strands_(std::move(strands)) {
  file_.write(kCsvHead);
}

void CsvWriter::add(double time, const particles::State& state) {
  std::string line;
  int particle = 0;
  const auto line_of = [&](int i, int strand) {
    line.clear();
    add_field(line, frame_);
    add_field(line, time);
    if (strand >= 0)
      add_field(line, strand);
    else
      line += ',';
    add_field(line, particle);
    for (const Eigen::VectorXd* values : {&state.x, &state.v})
      for (int axis = 0; axis < 3; ++axis) add_field(line, (*values)[3 * i + axis]);
    line.back() = '\n';
    file_.write(line);
  };
  int i = 0;
  for (int strand = 0; strand < static_cast<int>(strands_.size()); ++strand)
    for (particle = 0; particle < strands_[strand]; ++particle) line_of(i++, strand);
  for (particle = 0; 3 * i < state.x.size(); ++particle) line_of(i++, -1);
  ++frame_;
}

}  // namespace hair
