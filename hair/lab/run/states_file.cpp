#include "hair/lab/run/states_file.h"

#include <array>
#include <bit>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>

namespace hair {

namespace {

static_assert(std::endian::native == std::endian::little, "files are written as memory is");

constexpr std::string_view kMagic = "HAIRRUN1", kLinksMagic = "BROKEN 1";
constexpr std::uint64_t kFramesAt = 16;  // bytes

std::string_view bytes_of(const std::uint32_t& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string_view bytes_of(const std::uint64_t& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string_view bytes_of(const double* values, Eigen::Index count) {
  return {reinterpret_cast<const char*>(values), sizeof(double) * static_cast<std::size_t>(count)};
}

}  // namespace

StatesWriter::StatesWriter(const std::filesystem::path& file, const std::filesystem::path& shown,
                           const std::vector<int>& strands, int particles, std::uint32_t coordinates)
    : file_(file, shown) {
  file_.write(kMagic);
  for (const std::uint32_t number :
       {static_cast<std::uint32_t>(strands.size()), static_cast<std::uint32_t>(particles), 0U, coordinates})
    file_.write(bytes_of(number));
  for (const int size : strands) file_.write(bytes_of(static_cast<std::uint32_t>(size)));
  file_.write(std::string(strands.size() % 2 * 4, '\0'));
}

void StatesWriter::add(double time, const particles::State& state) {
  file_.write(bytes_of(&time, 1));
  file_.write(bytes_of(state.x.data(), state.x.size()));
  file_.write(bytes_of(state.v.data(), state.v.size()));
  ++frames_;
}

void StatesWriter::add(const LinksFile& links) {
  file_.write(kLinksMagic);
  for (const std::size_t count : {links.particles.size(), links.broken.size()})
    file_.write(bytes_of(static_cast<std::uint32_t>(count)));
  for (const auto& ends : links.particles)
    for (const int particle : ends) file_.write(bytes_of(static_cast<std::uint32_t>(particle)));
  for (const BrokenLink& one : links.broken) {
    file_.write(bytes_of(static_cast<std::uint64_t>(one.step)));
    file_.write(bytes_of(static_cast<std::uint64_t>(one.link)));
  }
}

void StatesWriter::close() {
  file_.overwrite(kFramesAt, bytes_of(frames_));
  file_.close();
}

namespace {

// Fields, with a comma between them. The next line reuses the memory.
class Line {
 public:
  void begin() {
    text_.clear();
    first_ = true;
  }
  template <class Number>
  void add(Number number) {
    comma();
    std::array<char, 32> digits{};
    text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
  }
  void add_nothing() { comma(); }
  const std::string& end() { return text_ += '\n'; }

 private:
  void comma() {
    if (!std::exchange(first_, false)) text_ += ',';
  }
  std::string text_;
  bool first_ = true;
};

}  // namespace

CsvWriter::CsvWriter(const std::filesystem::path& file, const std::filesystem::path& shown,
                     std::vector<int> strands)
    : file_(file, shown), strands_(std::move(strands)) {
  file_.write(kCsvHead);
}

void CsvWriter::add(double time, const particles::State& state) {
  Line line;
  int particle = 0;
  const auto line_of = [&](int i, int strand) {
    line.begin();
    line.add(frame_);
    line.add(time);
    if (strand >= 0)
      line.add(strand);
    else
      line.add_nothing();
    line.add(particle);
    for (const Eigen::VectorXd* values : {&state.x, &state.v})
      for (int axis = 0; axis < 3; ++axis) line.add((*values)[3 * i + axis]);
    file_.write(line.end());
  };
  int i = 0;
  for (int strand = 0; strand < static_cast<int>(strands_.size()); ++strand)
    for (particle = 0; particle < strands_[strand]; ++particle) line_of(i++, strand);
  for (particle = 0; 3 * i < state.x.size(); ++particle) line_of(i++, -1);
  ++frame_;
}

}  // namespace hair
