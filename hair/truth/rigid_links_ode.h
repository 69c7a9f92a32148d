// A strand of rigid links as a system of ordinary differential equations. y has the quaternions of all
// joints, four numbers each, then their rates, three each (hair/rigid_links/link_tree.h); the accelerations
// are those of explicit steps. The base moves independently. Everything depends on everything: df/dy is a
// full matrix.
//
// A root that starts with a velocity was at rest before: this impulse turns the links at once.
#pragma once

#include <memory>
#include <vector>

#include "hair/rigid_links/link_strand.h"
#include "hair/truth/ode.h"
#include "hair/truth/problem.h"
#include "hair/truth/strand_root.h"

namespace hair {

class LinksOde : public Ode {
 public:
  // Copies the needed parts of the problem. Throws what its model's bodies throw.
  explicit LinksOde(const Problem& problem);

  int size() const override { return tree().coordinates() + tree().rates(); }
  Eigen::VectorXd start() const override { return start_; }
  Eigen::VectorXd scales() const override;
  std::vector<double> breaks() const override { return root_.breaks(); }
  void start_span(double t) override { root_.start_span(t); }
  void rates(double t, particles::Input y, particles::Output dy) override;
  particles::State state(double t, particles::Input y) override;
  Eigen::VectorXd points(const particles::State& state) const override;

 private:
  const LinkTree& tree() const { return system_.tree(); }
  TreeBase base_at(double t) const;
  LinksOde(const Problem& problem, const LinkStrand& strand);
  void set_in_motion();

  Scene scene_;
  StrandRoot root_;
  std::unique_ptr<Body> body_;  // gives states their meaning
  TreeSystem system_;
  std::vector<Eigen::Quaterniond>
      at_rest_;  // the links' axes in the rest shape, for the root's frame at the start
  Eigen::VectorXd start_, q_;
};

}  // namespace hair
