#include "hair/lab/run/states_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/simulation/models.h"

namespace hair {

namespace {

static_assert(std::endian::native == std::endian::little, "files are written as memory is");

constexpr std::string_view kMagic = "HAIRRUN1", kLinksMagic = "BROKEN 1";
constexpr std::uint64_t kHeader = 24, kFramesAt = 16, kLinksHeader = 16;  // bytes
constexpr std::uint64_t kSteps = std::uint64_t{1} << 53;

std::string_view bytes_of(const std::uint32_t& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string_view bytes_of(const std::uint64_t& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string_view bytes_of(const double* values, Eigen::Index count) {
  return {reinterpret_cast<const char*>(values), sizeof(double) * static_cast<std::size_t>(count)};
}

// What comes after the frames, `size` bytes. read(to, count) and fail(what): of the file.
template <class Read, class Fail>
LinksFile read_links(std::uint64_t size, std::uint64_t particles, const Read& read, const Fail& fail) {
  std::array<char, kLinksMagic.size()> magic{};
  std::array<std::uint32_t, 2> counts{};
  read(magic.data(), magic.size());
  read(counts.data(), sizeof counts);
  const std::uint64_t links = counts[0], broken = counts[1];
  if (std::string_view(magic.data(), magic.size()) != kLinksMagic || broken > links ||
      size != kLinksHeader + 8 * links + 16 * broken)
    fail("has " + std::to_string(size) + " bytes after its frames, which are no list of links");
  LinksFile file;
  for (std::uint64_t i = 0; i < links; ++i) {
    std::array<std::uint32_t, 2> ends{};
    read(ends.data(), sizeof ends);
    if (ends[0] >= particles || ends[1] >= particles)
      fail("link " + std::to_string(i) + " joins particles " + std::to_string(ends[0]) + " and " +
           std::to_string(ends[1]) + ", of " + std::to_string(particles) + " in all");
    file.particles.push_back({static_cast<int>(ends[0]), static_cast<int>(ends[1])});
  }
  for (std::uint64_t i = 0; i < broken; ++i) {
    std::array<std::uint64_t, 2> numbers{};  // step and link
    read(numbers.data(), sizeof numbers);
    std::array<std::uint64_t, 2> last{0, 0};
    if (i > 0)
      last = {static_cast<std::uint64_t>(file.broken.back().step),
              static_cast<std::uint64_t>(file.broken.back().link)};
    if (numbers[0] < 1 || numbers[0] >= kSteps || numbers[1] >= links || (i > 0 && numbers <= last))
      fail("the broken link number " + std::to_string(i) + " is out of order, or of bounds");
    file.broken.push_back({static_cast<long>(numbers[0]), static_cast<int>(numbers[1])});
  }
  return file;
}

std::uint64_t padding(std::uint64_t strands) {
  return strands % 2 * 4;
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
  file_.write(std::string(padding(strands.size()), '\0'));
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

StatesFile read_states(const std::filesystem::path& file) {
  const auto fail = [&](const std::string& what) {
    throw BadInput(printable(file.string(), 4096) + ": " + what +
                   "; hairlab writes such files as states.bin");
  };
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) fail("can't be read");
  const auto read = [&](void* to, std::size_t count) {
    if (!in.read(static_cast<char*>(to), static_cast<std::streamsize>(count)))
      fail("can't be read to its end");
  };

  std::array<char, kMagic.size()> magic{};
  std::array<std::uint32_t, 4> numbers{};
  if (size < kHeader) fail("is too short to be a file of states");
  read(magic.data(), magic.size());
  read(numbers.data(), sizeof numbers);
  if (std::string_view(magic.data(), magic.size()) != kMagic) fail("is no file of states");
  std::string known;
  for (const ModelRow& model : models())
    known +=
        (known.empty() ? "" : ", ") + std::to_string(model.coordinates) + " (" + model.coordinates_name + ")";
  if (std::none_of(models().begin(), models().end(),
                   [&](const ModelRow& model) { return model.coordinates == numbers[3]; }))
    fail("has coordinates of the kind " + std::to_string(numbers[3]) +
         ", which this program does not know; it knows " + known);
  const std::uint64_t strands = numbers[0], particles = numbers[1], frames = numbers[2];
  // None of these overflows, for each number is below 2^32; and all is compared with the size before anything
  // of that size is made.
  const std::uint64_t before = kHeader + 4 * strands + padding(strands), frame = 8 * (1 + 6 * particles);
  // frames < 2^32, and frame < 2^35 if the first holds.
  const bool room = particles <= (1U << 28) && size >= before && (size - before) / frame >= frames;
  const std::uint64_t after = room ? size - before - frames * frame : 0;
  if (!room || (after > 0 && after < kLinksHeader))
    fail("has " + std::to_string(size) + " bytes, which are not those of " + std::to_string(frames) +
         " frames of " + std::to_string(particles) + " particles in " + std::to_string(strands) + " strands");

  StatesFile states;
  states.coordinates = numbers[3];
  states.particles = static_cast<int>(particles);
  std::uint64_t sum = 0;
  for (std::uint64_t i = 0; i < strands; ++i) {
    std::uint32_t count = 0;
    read(&count, sizeof count);
    sum += count;
    if (count == 0 || sum > particles)
      fail("strand " + std::to_string(i) + " has " + std::to_string(count) + " particles, of " +
           std::to_string(particles) + " in all");
    states.strands.push_back(static_cast<int>(count));
  }
  std::uint32_t zeros = 0;
  read(&zeros, padding(strands));
  if (zeros != 0) fail("has something else where zeros belong");
  const auto numbers_each = static_cast<Eigen::Index>(3 * particles);
  for (std::uint64_t k = 0; k < frames; ++k) {
    StateFrame& next = states.frames.emplace_back();
    next.state = {Eigen::VectorXd(numbers_each), Eigen::VectorXd(numbers_each)};
    read(&next.time, sizeof next.time);
    read(next.state.x.data(), sizeof(double) * static_cast<std::size_t>(numbers_each));
    read(next.state.v.data(), sizeof(double) * static_cast<std::size_t>(numbers_each));
  }
  if (after > 0) states.links = read_links(after, particles, read, fail);
  return states;
}

}  // namespace hair
