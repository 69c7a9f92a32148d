#include "hair/render/fine/hair_layer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace hair {
namespace {

constexpr int kTile = 64;  // pixels along a side
constexpr int kBatches = 64;
constexpr float kNearestHair = 0.01F;   // in the view's unit
constexpr float kNoSolid = 99;          // the view's far end is at 100: there is no solid
constexpr float kHidden = 1.0F / 1024;  // a smaller part of the colours behind is invisible
constexpr float kOnSolids = 3;          // half widths: hair that lies on a solid is not in it
constexpr float kThinnest = 1e-4F;      // pixels; thinner hair is invisible

// A pixel during drawing, with the parts of HairLayer.
struct Pixel {
  Colour colour = Colour::Zero();
  float of_solid = 1, of_empty = 1;
};

// A piece of a strand on the picture.
struct Piece {
  std::array<float, 2> x, y, half;  // for both ends, pixels; half: half its width
  float distance;                   // its middle's
};

struct PieceOf {
  int strand, segment, piece, pieces;
};

class HairPainter {
 public:
  HairPainter(const StrandsDrawing& drawing, const FineStrands& strands, const View& view, int width,
              int height, const HairSurroundings& around)
      : drawing_(drawing),
        strands_(strands),
        up_(view.direction(Vector3d(0, 0, 1))),
        around_(around),
        width_(width),
        height_(height),
        scale_(static_cast<float>(height) / (2 * view.tangent_y())),
        across_((width + kTile - 1) / kTile),
        tiles_(static_cast<std::size_t>(across_ * ((height + kTile - 1) / kTile))) {}

  HairLayer draw(StrandThreads& threads) {
    sort_into_tiles(threads);
    const std::size_t size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    HairLayer layer{width_, height_, std::vector<float>(4 * size), std::vector<float>(size)};
    const StrandThreads::Task task = [&](int, int tile) { draw_tile(tile, layer); };
    threads.run(static_cast<int>(tiles_), task);
    return layer;
  }

 private:
  using Key = std::uint64_t;  // the distance's bits, then point and piece

  // Returns true if a part of the piece is visible.
  bool project(const CurveSegment& segment, const PieceOf& of, Piece& piece) const {
    piece.distance = 0;
    for (std::size_t end = 0; end < 2; ++end) {
      const float u =
          (static_cast<float>(of.piece) + static_cast<float>(end)) / static_cast<float>(of.pieces);
      const Eigen::Vector3f at = segment.at(u);
      const float distance = -at[2];
      if (!(distance > kNearestHair)) return false;
      const float pixels = scale_ / distance;
      piece.x[end] = 0.5F * static_cast<float>(width_) + at[0] * pixels;
      piece.y[end] = 0.5F * static_cast<float>(height_) + at[1] * pixels;
      piece.half[end] = strands_.half_width(strands_.along(of.strand, of.segment, u)) * pixels;
      piece.distance += 0.5F * distance;
    }
    return piece.half[0] > kThinnest;
  }

  // Calls visit(tile) for each tile that the piece may touch.
  template <class Visit>
  void for_tiles(const Piece& piece, const Visit& visit) const {
    // An upright or level strand extends half a width and a pixel to the side, a slanted one up to sqrt(2)
    // times the half.
    const float reach = 1 + 1.5F * std::max(piece.half[0], piece.half[1]);
    const auto range = [&](const std::array<float, 2>& ends, int size) {
      const float low = std::min(ends[0], ends[1]) - reach, high = std::max(ends[0], ends[1]) + reach;
      if (!(high >= 0 && low < static_cast<float>(size))) return std::array{0, -1};
      const auto side = static_cast<float>(size - 1);
      return std::array{static_cast<int>(std::max(low, 0.0F)) / kTile,
                        static_cast<int>(std::min(high, side)) / kTile};
    };
    const auto columns = range(piece.x, width_), rows = range(piece.y, height_);
    for (int row = rows[0]; row <= rows[1]; ++row)
      for (int column = columns[0]; column <= columns[1]; ++column) visit(row * across_ + column);
  }

  template <class Visit>
  void for_pieces(int batch, const Visit& visit) const {
    const auto part = [&](int b) {
      return static_cast<int>(static_cast<long>(strands_.count()) * b / kBatches);
    };
    Piece piece{};
    for (int strand = part(batch); strand < part(batch + 1); ++strand)
      for (int i = 0; i < strands_.segments(strand); ++i) {
        const CurveSegment segment = strands_.segment(strand, i);
        const int pieces = strands_.pieces(segment);
        for (int k = 0; k < pieces; ++k) {
          if (!project(segment, {strand, i, k, pieces}, piece)) continue;
          const std::uint32_t name = (strands_.first(strand) + static_cast<std::uint32_t>(i)) *
                                         static_cast<std::uint32_t>(FineStrands::kMostPieces) +
                                     static_cast<std::uint32_t>(k);
          const Key key = static_cast<Key>(std::bit_cast<std::uint32_t>(piece.distance)) << 32 | name;
          for_tiles(piece, [&](int tile) { visit(static_cast<std::size_t>(tile), key); });
        }
      }
  }

  // Counts first, so that each tile's keys are in one place of the right size.
  void sort_into_tiles(StrandThreads& threads) {
    std::vector<std::size_t> places(kBatches * tiles_, 0);
    const StrandThreads::Task count = [&](int, int batch) {
      std::size_t* const of = places.data() + static_cast<std::size_t>(batch) * tiles_;
      for_pieces(batch, [&](std::size_t tile, Key) { ++of[tile]; });
    };
    threads.run(kBatches, count);
    begin_.assign(tiles_ + 1, 0);
    std::size_t sum = 0;
    for (std::size_t tile = 0; tile < tiles_; ++tile) {
      begin_[tile] = sum;
      for (std::size_t batch = 0; batch < kBatches; ++batch) {
        const std::size_t here = places[batch * tiles_ + tile];
        places[batch * tiles_ + tile] = sum;
        sum += here;
      }
    }
    begin_[tiles_] = sum;
    keys_.resize(sum);
    const StrandThreads::Task fill = [&](int, int batch) {
      std::size_t* const of = places.data() + static_cast<std::size_t>(batch) * tiles_;
      for_pieces(batch, [&](std::size_t tile, Key key) { keys_[of[tile]++] = key; });
    };
    threads.run(kBatches, fill);
  }

  // Parts of a pixel: without a solid, with one, and with one behind the hair.
  struct Parts {
    float empty = 1, solid = 0, before = 0;
  };
  Parts parts_of(int x, int y, float distance) const {
    if (around_.distances.empty()) return {};
    const int n = around_.samples;
    int solid = 0, before = 0;
    for (int row = n * y; row < n * (y + 1); ++row)
      for (int column = n * x; column < n * (x + 1); ++column) {
        const float there =
            around_.distances[static_cast<std::size_t>(row) * static_cast<std::size_t>(n * width_) +
                              static_cast<std::size_t>(column)];
        if (there >= kNoSolid) continue;
        ++solid;
        before += there > distance ? 1 : 0;
      }
    const auto all = static_cast<float>(n * n);
    return {1 - static_cast<float>(solid) / all, static_cast<float>(solid) / all,
            static_cast<float>(before) / all};
  }

  void draw_tile(int tile, HairLayer& layer) {
    const auto index = static_cast<std::size_t>(tile);
    const auto first = keys_.begin() + static_cast<std::ptrdiff_t>(begin_[index]),
               last = keys_.begin() + static_cast<std::ptrdiff_t>(begin_[index + 1]);
    std::sort(first, last);
    const int left = tile % across_ * kTile, below = tile / across_ * kTile;
    const Eigen::AlignedBox2i box(
        Eigen::Vector2i(left, below),
        Eigen::Vector2i(std::min(left + kTile, width_), std::min(below + kTile, height_)));
    std::vector<Pixel> pixels(kTile * kTile);
    for (auto key = first; key != last; ++key) draw_piece(static_cast<std::uint32_t>(*key), box, pixels);
    for (int y = below; y < box.max()[1]; ++y)
      for (int x = left; x < box.max()[0]; ++x) {
        const std::size_t place =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
        const Pixel& pixel = pixels[static_cast<std::size_t>(kTile * (y - below) + x - left)];
        std::copy_n(pixel.colour.data(), 3, layer.pixels.begin() + static_cast<std::ptrdiff_t>(4 * place));
        layer.pixels[4 * place + 3] = pixel.of_solid;
        layer.empty[place] = pixel.of_empty;
      }
  }

  void draw_piece(std::uint32_t name, const Eigen::AlignedBox2i& box, std::vector<Pixel>& pixels) const {
    const std::uint32_t point = name / FineStrands::kMostPieces;
    PieceOf of{strands_.strand_of(point), 0, static_cast<int>(name % FineStrands::kMostPieces), 0};
    of.segment = static_cast<int>(point - strands_.first(of.strand));
    const CurveSegment segment = strands_.segment(of.strand, of.segment);
    of.pieces = strands_.pieces(segment);
    Piece piece{};
    if (!project(segment, of, piece)) return;

    // Goes through columns of a strand that is more level than upright, and through rows of one that is more
    // upright: `major` is that axis.
    const float dx = piece.x[1] - piece.x[0], dy = piece.y[1] - piece.y[0];
    const int major = std::abs(dx) >= std::abs(dy) ? 0 : 1, minor = 1 - major;
    const std::array<float, 2>&a = major == 0 ? piece.x : piece.y, &b = major == 0 ? piece.y : piece.x;
    const float along = a[1] - a[0];
    if (along == 0) return;
    const float slope = (b[1] - b[0]) / along, slanted = std::sqrt(1 + slope * slope);
    // Pixels whose middle is at or beyond one end, and before the other: the next piece begins where this one
    // ends.
    const auto first_middle = [&](float end) {
      return static_cast<int>(std::clamp(std::ceil(end - 0.5F), static_cast<float>(box.min()[major]),
                                         static_cast<float>(box.max()[major])));
    };
    const int begin = first_middle(std::min(a[0], a[1])), end = first_middle(std::max(a[0], a[1]));

    std::array<Colour, 2> colours;
    bool shaded = false;
    for (int i = begin; i < end; ++i) {
      const float part = (static_cast<float>(i) + 0.5F - a[0]) / along;
      const float middle = b[0] + part * (b[1] - b[0]);
      const float half = (piece.half[0] + part * (piece.half[1] - piece.half[0])) * slanted;
      const auto bound = [&](float value) {
        return static_cast<int>(
            std::clamp(value, static_cast<float>(box.min()[minor]), static_cast<float>(box.max()[minor])));
      };
      const int low = bound(std::floor(middle - half - 0.5F)),
                high = bound(std::ceil(middle + half + 0.5F) + 1);
      for (int j = low; j < high; ++j) {
        const int x = major == 0 ? i : j, y = major == 0 ? j : i;
        Pixel& pixel = pixels[static_cast<std::size_t>(kTile * (y - box.min()[1]) + x - box.min()[0])];
        if (std::max(pixel.of_solid, pixel.of_empty) < kHidden) continue;
        const float off = middle - (static_cast<float>(j) + 0.5F);
        const float covered = tent_integral(off + half) - tent_integral(off - half);
        if (covered <= 0) continue;
        const Parts parts = parts_of(x, y, piece.distance - kOnSolids * strands_.half_width(0));
        const float seen = covered * (parts.empty * pixel.of_empty + parts.before * pixel.of_solid);
        pixel.of_empty *= 1 - covered;
        pixel.of_solid *= parts.solid > 0 ? 1 - covered * parts.before / parts.solid : 1 - covered;
        if (seen <= 0) continue;
        if (!shaded) colours = {colour(segment, of, 0), colour(segment, of, 1)};
        shaded = true;
        pixel.colour += seen * (colours[0] + part * (colours[1] - colours[0]));
      }
    }
  }

  Colour colour(const CurveSegment& segment, const PieceOf& of, int end) const {
    const float u = static_cast<float>(of.piece + end) / static_cast<float>(of.pieces);
    HairPoint point{segment.at(u), segment.slope(u), strands_.along(of.strand, of.segment, u), 0, 1};
    const float steepness = point.tangent.norm();
    point.tangent = steepness > 0 ? Eigen::Vector3f(point.tangent / steepness) : Eigen::Vector3f(0, 1, 0);
    if (around_.opacity) point.opacity = around_.opacity(point.at);
    if (around_.lit) point.lit = around_.lit(point.at);
    return shaded_hair(point, strand_tint(drawing_, drawing_.id(static_cast<std::size_t>(of.strand))), up_);
  }

  const StrandsDrawing& drawing_;
  const FineStrands& strands_;
  const Eigen::Vector3f up_;
  const HairSurroundings& around_;
  const int width_, height_;
  const float scale_;  // pixels at a distance of 1
  const int across_;   // tiles in a row
  const std::size_t tiles_;
  std::vector<Key> keys_;
  std::vector<std::size_t> begin_;  // for each tile's keys, and their number
};

}  // namespace

HairLayer draw_hair_layer(const StrandsDrawing& drawing, const FineStrands& strands, const View& view,
                          int width, int height, const HairSurroundings& around, StrandThreads& threads) {
  return HairPainter(drawing, strands, view, width, height, around).draw(threads);
}

}  // namespace hair
