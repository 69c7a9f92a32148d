#include "hair/lab/run/states_csv.h"

#include <array>
#include <charconv>
#include <utility>

namespace hair {

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
