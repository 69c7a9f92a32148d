// Hostile bytes as a PLY file. What is accepted can be written in both ways, and is read as 32 bits hold it.
#include "hair/head/ply_file.h"

#include "hair/io/files/bad_input.h"
#include "hair/io/fuzz/fuzz.h"

void fuzz::try_input(std::string_view bytes) {
  hair::Groom groom;
  try {
    groom = hair::parse_ply_file(bytes, "a.ply");
  } catch (const hair::BadInput& error) {
    expect_readable(error.what());
    expect(std::string_view(error.what()).starts_with("a.ply: "), "a message begins with the file's name");
    return;
  }
  for (const Eigen::VectorXd& x : groom.strands) {
    expect(x.size() >= 6 && x.size() % 3 == 0, "a strand has two points or more");
    expect(x.allFinite(), "points are finite");
  }
  for (const bool ascii : {false, true}) {
    const hair::Groom again = hair::parse_ply_file(hair::ply_file_of(groom, ascii), "b.ply");
    expect(again.look.colours == groom.look.colours, "colours stay");
    expect(again.strands.size() == groom.strands.size(), "strands stay");
    for (std::size_t i = 0; i < groom.strands.size(); ++i)
      expect(again.strands[i] == groom.strands[i].cast<float>().cast<double>(), "points stay, as 32 bits");
  }
}

// As text a point is six bytes; here 24 in a list and 24 in its strand, in this groom and in the one that is
// read again from up to 60 bytes of text and two edges.
std::size_t fuzz::most_memory(std::size_t input) {
  return 20'000 + 100 * input;
}

std::vector<std::string> fuzz::seeds() {
  const auto line = [](int points) -> Eigen::VectorXd {
    return Eigen::VectorXd::LinSpaced(3 * points, 0, 1.5 * points);
  };
  hair::Groom groom{{line(2), line(3), line(5)}};
  std::vector<std::string> all = {hair::ply_file_of(groom), hair::ply_file_of(groom, true)};
  groom.look.colours.assign(30, 0.2F);
  all.push_back(hair::ply_file_of(groom));
  all.push_back(hair::ply_file_of(groom, true));
  std::string big = all[0];
  all.push_back(big.replace(big.find("little"), 6, "big"));
  all.emplace_back(
      "ply\nformat ascii 1.0\nelement thing 1\nproperty list uchar int of\nelement vertex 2\nproperty double "
      "z\n"
      "property float y\nproperty int8 x\nelement strand 1\nproperty uint nsegs\nend_header\n2 5 6\n1 2 3\n4 "
      "5 6\n1\n");
  return all;
}
