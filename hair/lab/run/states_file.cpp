#include "hair/lab/run/states_file.h"

#include <bit>
#include <string>
#include <string_view>

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

}  // namespace hair
