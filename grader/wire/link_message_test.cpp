// STAFF ONLY.
#include "grader/wire/link_message.h"

#include <gtest/gtest.h>

namespace grader {
namespace {

using hair::JointType, hair::Link, hair::LinkPass;

std::vector<Link> three_links() {
  std::vector<Link> links(3);
  links[1].joint = JointType::spherical;
  links[2].parent = 1;
  links[2].first = 3;
  links[2].u = hair::Vector3d(1, 2, 3);
  links[2].inertia.H(0, 1) = 4;
  links[2].stiffening(2, 2) = 5;
  return links;
}

TEST(LinkMessage, GivesBackWhatWasPut) {
  std::vector<LinkPass> passes(3);
  passes[1].v.linear = hair::Vector3d(6, 7, 8);
  passes[2].gain(1, 2) = 9;
  passes[2].a.angular = hair::Vector3d(10, 11, 12);
  MessageWriter message;
  put(message, three_links());
  put(message, passes);
  MessageReader reader(message.bytes());
  int rates = 0;
  const std::vector<Link> links = get_links(reader, rates);
  EXPECT_EQ(rates, 4);
  EXPECT_EQ(links[1].joint, JointType::spherical);
  EXPECT_EQ(links[2].parent, 1);
  EXPECT_EQ(links[2].u, hair::Vector3d(1, 2, 3));
  EXPECT_EQ(links[2].inertia.H(0, 1), 4);
  EXPECT_EQ(links[2].stiffening(2, 2), 5);
  const std::vector<LinkPass> got = get_passes(reader, 3);
  EXPECT_EQ(got[1].v.linear, passes[1].v.linear);
  EXPECT_EQ(got[2].gain(1, 2), 9);
  EXPECT_EQ(got[2].a.angular, passes[2].a.angular);
  reader.expect_end();
}

TEST(LinkMessage, RefusesTreesThatAreNone) {
  const auto refused = [](auto spoil) {
    std::vector<Link> links = three_links();
    spoil(links);
    MessageWriter message;
    put(message, links);
    MessageReader reader(message.bytes());
    int rates = 0;
    EXPECT_THROW(get_links(reader, rates), MalformedMessage);
  };
  refused([](auto& links) { links.clear(); });
  refused([](auto& links) { links[2].parent = 2; });
  refused([](auto& links) { links[1].parent = -1; });
  refused([](auto& links) { links[1].joint = static_cast<JointType>(3); });
  refused([](auto& links) { links[2].first = 1; });
  MessageReader nothing({});
  EXPECT_THROW(get_passes(nothing, 1), MalformedMessage);
}

}  // namespace
}  // namespace grader
