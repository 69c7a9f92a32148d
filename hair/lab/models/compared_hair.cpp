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
                                     level("curly", "Curly hair, curls of 2 cm", Curly{0.01, 0.02})};
  if (quick) {
    hairs[0].elements = {5, 10};
    hairs[1].elements = {20};
    hairs[2].elements = {16};
    hairs[0].helices = {2, 4};
    hairs[2].helices = {10};
    hairs[1].helices = {20};
    hairs[0].fine = 20;
    hairs[1].fine = 20;
    hairs[2].fine = 16;
  } else {
    hairs[0].elements = {5, 10, 20, 40};
    hairs[1].elements = {20, 40, 80};
    hairs[2].elements = {16, 32, 64};
    hairs[0].helices = {1, 2, 3, 5, 10, 20};
    hairs[2].helices = {5, 10, 20, 40};
    hairs[1].helices = {20, 40};
    hairs[0].fine = 60;
    hairs[1].fine = 80;
    hairs[2].fine = 64;
  }
  return hairs;
}

}  // namespace hair::model_study
