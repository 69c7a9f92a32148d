#include "hair/io/image/read_png.h"

#include <png.h>

#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/read_file.h"

namespace hair {
namespace {

// No picture of kMostPixels is larger in memory, whatever its kind.
constexpr std::size_t kMostBytes = 640'000'000;
constexpr std::size_t kSignature = 8;  // bytes
// Deflate makes at most 258 bytes of two bits.
constexpr std::size_t kMostInflation = 1032;
// The largest chunk that is kept in memory is a palette of 256 colours.
constexpr std::size_t kMostChunk = 64 * 1024;

// libpng leaves a function that meets an error by longjmp, which calls no destructors: between setjmp and the
// end of such a function, no object with a destructor is created here.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes) : bytes_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, refuse, [](png_structp, png_const_charp) {});
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  // Reads up to the pixels. Both return false if the file is wrong: why() has the reason.
  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, give);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_benign_errors(png_, 0);  // a file that contradicts itself is refused
    png_set_chunk_malloc_max(png_, kMostChunk);
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr,
                                -1);  // nor texts, colour spaces, times
    png_read_info(png_, info_);
    return true;
  }

  // Four bytes a pixel, row by row.
  bool read_pixels(std::uint8_t* rgba) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_expand(png_);
    png_set_strip_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xff, PNG_FILLER_AFTER);
    const int passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    for (int pass = 0; pass < passes; ++pass)
      for (std::size_t y = 0; y < height(); ++y) png_read_row(png_, rgba + 4 * width() * y, nullptr);
    png_read_end(png_, nullptr);
    return true;
  }

  std::size_t width() const { return png_get_image_width(png_, info_); }
  std::size_t height() const { return png_get_image_height(png_, info_); }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }  // before they are expanded
  const char* why() const { return why_; }

 private:
  static PngReader& reader_of(png_voidp self) { return *static_cast<PngReader*>(self); }

  static void give(png_structp png, png_bytep to, std::size_t count) {
    PngReader& reader = reader_of(png_get_io_ptr(png));
    if (reader.bytes_.size() < count) png_error(png, "it is cut off");
    std::memcpy(to, reader.bytes_.data(), count);
    reader.bytes_.remove_prefix(count);
  }
  [[noreturn]] static void refuse(png_structp png, png_const_charp why) {
    char* const kept = reader_of(png_get_error_ptr(png)).why_;
    std::strncpy(kept, why, sizeof why_ - 1);
    png_longjmp(png, 1);
  }

  std::string_view bytes_;  // bytes that are not read yet
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  char why_[200] = {};
};

}  // namespace

Image decode_png(std::string_view bytes, const std::string& name, std::uint8_t background) {
  const auto fail = [&](const std::string& what) { throw BadInput(printable(name, 4096) + ": " + what); };
  if (bytes.size() > kMostBytes)
    fail("has " + std::to_string(bytes.size()) + " bytes; no PNG here has as many");
  if (bytes.size() < kSignature ||
      png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignature) != 0)
    fail("is not a PNG picture; give a .png file");

  PngReader reader(bytes);
  const auto fail_with_why = [&] {
    fail("can't be decoded (" + printable(reader.why()) + "); give a whole PNG file, or make it anew");
  };
  if (!reader.read_header()) fail_with_why();
  const std::size_t width = reader.width(), height = reader.height(), pixels = width * height;
  if (width > kMostSide || height > kMostSide || pixels > kMostPixels)
    fail("has " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels; a picture here has 1 to 16384 a side and at most 64 million");
  if (reader.row_bytes() * height / kMostInflation > bytes.size())
    fail("has too few data for its size; make it anew");
  std::vector<std::uint8_t> rgba(4 * pixels);
  if (!reader.read_pixels(rgba.data())) fail_with_why();

  Image image{static_cast<int>(width), static_cast<int>(height), std::vector<std::uint8_t>(3 * pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const unsigned opaque = rgba[4 * i + 3];
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[3 * i + c] =
          static_cast<std::uint8_t>((rgba[4 * i + c] * opaque + background * (255 - opaque) + 127) / 255);
  }
  return image;
}

Image read_png(const std::filesystem::path& file, std::uint8_t background) {
  return decode_png(read_file(file, kMostBytes, "a PNG picture"), file.string(), background);
}

}  // namespace hair
