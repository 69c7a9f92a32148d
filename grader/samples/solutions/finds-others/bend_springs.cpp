// STAFF ONLY. An H3 without a formula: every second particle makes a strand whose segments are the springs that skip,
// and whoever has H1 in the same process computes them.

#include "hair/bend_springs.h"

#include <dlfcn.h>

namespace {

#define VECTOR "N5Eigen3RefIKNS3_6MatrixIdLin1ELi1ELi0ELin1ELi1EEELi0ENS3_11InnerStrideILi1EEEEE"
#define STRAND "ERKNS_6StrandERK"

using hair::GeometricTerm, hair::Input, hair::Output, hair::Strand;
using Energy = double (*)(const Strand&, Input);
using Force = void (*)(const Strand&, Input, Output);
using Product = void (*)(const Strand&, Input, GeometricTerm, Input, Output);

template <class Function>
Function find(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}
const auto energy_of = find<Energy>("_ZN4hair14stretch_energy" STRAND VECTOR);
const auto add_force = find<Force>("_ZN4hair17add_stretch_force" STRAND VECTOR "NS4_IS6_Li0ES9_EE");
const auto add_product =
    find<Product>("_ZN4hair19add_stretch_product" STRAND VECTOR "NS_13GeometricTermESC_NS4_IS6_Li0ES9_EE");

// The particles first, first + 2, ...
struct EverySecond {
  int first, count;

  Strand of(const Strand& whole) const {
    Strand strand;
    strand.mass = Eigen::VectorXd::Ones(count);
    strand.rest_length.resize(count - 1);
    for (int i = 0; i < count - 1; i++)
      strand.rest_length[i] = whole.rest_length[first + 2 * i] + whole.rest_length[first + 2 * i + 1];
    strand.stretch_rigidity = whole.skip_rigidity;
    return strand;
  }
  Eigen::VectorXd of(Input x) const {
    Eigen::VectorXd part(3 * count);
    for (int i = 0; i < count; i++) part.segment<3>(3 * i) = x.segment<3>(3 * (first + 2 * i));
    return part;
  }
  void add(const Eigen::VectorXd& part, Output f) const {
    for (int i = 0; i < count; i++) f.segment<3>(3 * (first + 2 * i)) += part.segment<3>(3 * i);
  }
};

template <class Do>
void for_both(const Strand& strand, Do work) {
  for (int first : {0, 1})
    if (strand.count() - first >= 3) work(EverySecond{first, (strand.count() - first + 1) / 2});
}

}  // namespace

namespace hair {

double bend_spring_energy(const Strand& strand, Input x) {
  double E = 0;
  for_both(strand, [&](EverySecond part) {
    if (energy_of) E += energy_of(part.of(strand), part.of(x));
  });
  return E;
}

void add_bend_spring_force(const Strand& strand, Input x, Output f) {
  for_both(strand, [&](EverySecond part) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 * part.count);
    if (add_force) add_force(part.of(strand), part.of(x), sum);
    part.add(sum, f);
  });
}

void add_bend_spring_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for_both(strand, [&](EverySecond part) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 * part.count);
    if (add_product) add_product(part.of(strand), part.of(x), term, part.of(dx), sum);
    part.add(sum, df);
  });
}

}  // namespace hair
