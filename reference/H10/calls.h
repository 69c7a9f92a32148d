// STAFF ONLY. The calls of H10; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "grader/calls/server.h"
#include "hair/strand_synthesis.h"

namespace grader {

template <>
struct Form<hair::RootFrame> {
  using T = hair::RootFrame;
  static constexpr auto fields = std::tuple(&T::position, &T::axis, &T::side);
};

template <>
struct Form<hair::GuideHair> {
  static constexpr auto fields = std::tuple(&hair::GuideHair::root, &hair::GuideHair::points);
};

template <>
struct Form<hair::GuideFrames> {
  static constexpr auto fields = std::tuple(&hair::GuideFrames::arc, &hair::GuideFrames::turns);
};

// Guides see points in the host's memory.
template <class Host, Contract contract>
class Stored<const std::array<hair::GuideHair, 3>&, Host, contract> : public StoredParameter {
 public:
  explicit Stored(Host&) {}
  void read(MessageReader& request) {
    std::array<hair::RootFrame, 3> roots;
    for (std::size_t k = 0; k < 3; ++k) {
      decode(request, roots[k]);
      points_[k].emplace(request.get_doubles());
    }
    const auto guide = [&](std::size_t k) {
      return hair::GuideHair{roots[k], {points_[k]->view().data(), points_[k]->view().size()}};
    };
    guides_.emplace(std::array<hair::GuideHair, 3>{guide(0), guide(1), guide(2)});
  }
  const std::array<hair::GuideHair, 3>& view() const { return *guides_; }
  Eigen::Index size() const { return (*guides_)[0].points.size(); }

 private:
  std::array<std::optional<typename Host::Vector>, 3> points_;
  std::optional<std::array<hair::GuideHair, 3>> guides_;
};

}  // namespace grader

namespace grader::h10 {

// Throws MalformedMessage unless all lines have the same number n >= 2 of points.
inline void expect_lines(std::initializer_list<Eigen::Index> sizes) {
  for (const Eigen::Index size : sizes)
    if (size < 6 || size % 3 != 0 || size != *sizes.begin())
      throw MalformedMessage("a line of " + std::to_string(size) + " numbers; others have " +
                             std::to_string(*sizes.begin()));
}

struct Lines {
  static void check(const std::array<hair::GuideHair, 3>& guides, const auto&, const auto&,
                    const auto& child) {
    expect_lines({child.size(), guides[0].points.size(), guides[1].points.size(), guides[2].points.size()});
  }
};
struct Frames {
  static void check(const auto& guide, const hair::GuideFrames& frames) {
    expect_lines({guide.size(), 3 * frames.arc.size(), 3 * static_cast<Eigen::Index>(frames.turns.size())});
  }
};
struct Wisp {
  static void check(const auto& guide, const hair::GuideFrames& frames, const auto&, double,
                    const auto& child) {
    expect_lines({guide.size(), child.size()});
    Frames::check(guide, frames);
  }
};
struct Blend {
  static void check(const auto& arc, const auto& at_root, const auto& at_tip, const auto& child) {
    expect_lines({3 * arc.size(), at_root.size(), at_tip.size(), child.size()});
  }
};

template <auto function, class Check>
using Lean = Call<function, Contract{}, Check>;

struct Calls : CallList<Lean<hair::root_weights, SameSizes>, Lean<hair::interpolate, Lines>,
                        Lean<hair::carry_along, Frames>, Lean<hair::extrapolate, Wisp>,
                        Call<hair::blend, Contract{.may_share = true}, Blend>> {
  static constexpr const char* id = "H10";
};

}  // namespace grader::h10
