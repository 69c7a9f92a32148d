#include "hair/io/image/png.h"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/write_file.h"
#include "hair/io/image/png_chunks.h"
#include "hair/io/image/stb.h"

namespace hair {
namespace {

// No picture of 64 million pixels is larger, whatever its kind.
constexpr std::size_t kMostBytes = 640'000'000;

std::string bytes_of(const std::filesystem::path& file) {
  const std::string name = printable(file.string(), 4096);
  const auto fail = [&](int error) {
    throw BadInput(name + ": can't be read (" + std::generic_category().message(error) +
                   "); give the path of a PNG picture");
  };
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) fail(EISDIR);
  const auto size = std::filesystem::file_size(file, error);
  if (error) fail(error.value());
  if (size > kMostBytes)
    throw BadInput(name + ": has " + std::to_string(size) + " bytes; no PNG here has as many");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(errno);
  std::string bytes(size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) fail(errno != 0 ? errno : EIO);
  return bytes;
}

// The same file with all 256 colours that a palette can have: black for those that it lacks. stb would take what
// its memory holds for these. It refuses a palette of no colours or too many, and looks at no checksum.
std::string with_whole_palette(std::string_view bytes, const PngChunks& chunks) {
  constexpr std::size_t whole = 3 * 256;
  std::string all(bytes);
  const std::size_t length = chunks.palette_length;
  if (length == 0 || length > whole || length % 3 != 0) return all;
  all[chunks.palette + 2] = static_cast<char>(whole >> 8);
  all[chunks.palette + 3] = static_cast<char>(whole & 0xff);
  return all.insert(chunks.palette + 8 + length, whole - length, '\0');
}

}  // namespace

std::string encode_png(const Image& image) {
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.width > kMostSide || image.height > kMostSide ||
      pixels > kMostPixels || image.pixels.size() != 3 * pixels) {
    throw std::invalid_argument("a picture of " + std::to_string(image.width) + " x " +
                                std::to_string(image.height) + " pixels with " +
                                std::to_string(image.pixels.size()) +
                                " bytes; it must have 1 to 16384 a side and three bytes for each");
  }
  return stb_encode_png(image.width, image.height, image.pixels.data());
}

Image decode_png(std::string_view bytes, const std::string& name) {
  const auto fail = [&](const std::string& what) { throw BadInput(printable(name, 4096) + ": " + what); };
  if (bytes.size() > kMostBytes)
    fail("has " + std::to_string(bytes.size()) + " bytes; no PNG here has as many");
  std::string with_colours;
  {
    // stb takes as much memory as the data ask for: those that ask for too much never reach it.
    const PngChunks chunks = read_png_chunks(bytes, name);
    if (!stb_inflates(chunks.data, chunks.most)) {
      fail("its data are damaged, or more than its header says; make it anew");
    }
    if (chunks.palette != 0) with_colours = with_whole_palette(bytes, chunks);
  }
  const StbPicture picture = stb_decode_png(with_colours.empty() ? bytes : with_colours);
  if (!picture.why_not.empty()) fail(picture.why_not + "; make it anew");

  Image image{picture.width, picture.height, {}};
  image.pixels.resize(picture.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i) {
    const unsigned opaque = picture.rgba[4 * i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      image.pixels[3 * i + c] = static_cast<std::uint8_t>((picture.rgba[4 * i + c] * opaque + 127) / 255);
    }
  }
  return image;
}

Image read_png(const std::filesystem::path& file) {
  return decode_png(bytes_of(file), file.string());
}

void write_png(const std::filesystem::path& file, const Image& image) {
  write_file(file, encode_png(image));
}

}  // namespace hair
