#include "hair/lab/models/compared_hair.h"

namespace hair::model_study {

namespace {

ComparedHair level(std::string id, std::string title, const RestForm& form) {
  ComparedHair hair{std::move(id), std::move(title), {}, {}, {}, 0};
  hair.spec.form = form;
  hair.spec.length = 0.2;
  hair.spec.root.axis = Vector3d(1, 0, 0);
  hair.spec.root.side = Vector3d(0, 0, 1);
  return hair;
}

}  // namespace

std::vector<ComparedHair> compared_hairs(bool quick) {
  std::vector<ComparedHair> hairs = {level("straight", "Straight hair", Straight{}),
                                     level("wavy", "Wavy hair, waves of 4 cm", Wavy{0.004, 0.04}),
                                     level("curly", "Curly hair, curls of 2 cm", Curly{0.01, 0.02}),
                                     level("uncoiling", "A hanging curl that uncoils", Curly{0.01, 0.02})};
  hairs[3].spec.root.axis = Vector3d(0, 0, -1);
  hairs[3].spec.root.side = Vector3d(1, 0, 0);
  hairs[0].elements = quick ? std::vector{5, 10} : std::vector{5, 10, 20, 40};
  hairs[0].helices = quick ? std::vector{2, 4} : std::vector{1, 2, 3, 5, 10, 20};
  hairs[0].fine = quick ? 20 : 60;
  hairs[1].elements = quick ? std::vector{20} : std::vector{20, 40, 80};
  hairs[1].helices = quick ? std::vector{20} : std::vector{20, 40};
  hairs[1].fine = quick ? 20 : 80;
  for (const int curl : {2, 3}) {
    hairs[curl].elements = quick ? std::vector{16} : std::vector{16, 32, 64};
    hairs[curl].helices = quick ? std::vector{10} : std::vector{3, 5, 10, 20, 40};
    hairs[curl].fine = quick ? 16 : 64;
  }
  return hairs;
}

}  // namespace hair::model_study
