// STAFF ONLY.
#include "grader/wire/mesh_message.h"

#include <gtest/gtest.h>

namespace grader {
namespace {

TEST(MeshMessage, GivesBackWhatWasPut) {
  const hair::StaticLink link{1, 2, {3, 4, 5}, 6, 7, 8, 9};
  const hair::StripContact contact{1, {2, 3, 4}, {5, 6, 7}, {8, 9, 10}, 11};
  const std::vector<hair::Matrix3d> frames = {hair::Matrix3d::Identity(), hair::Matrix3d::Constant(3)};
  MessageWriter message;
  put(message, std::vector{link});
  put(message, frames);
  put(message, hair::StripLaw{1, 2, 3});
  put(message, std::vector{contact});

  MessageReader reader(message.bytes());
  const std::vector<hair::StaticLink> links = get_static_links(reader);
  ASSERT_EQ(links.size(), 1U);
  EXPECT_EQ(links[0].a, 1);
  EXPECT_EQ(links[0].b, 2);
  EXPECT_EQ(links[0].offset, link.offset);
  EXPECT_EQ(links[0].length, 6);
  EXPECT_EQ(links[0].stiffness, 7);
  EXPECT_EQ(links[0].yields, 8);
  EXPECT_EQ(links[0].breaks, 9);
  EXPECT_EQ(get_particle_frames(reader), frames);
  const hair::StripLaw law = get_strip_law(reader);
  EXPECT_EQ(law.thickness, 1);
  EXPECT_EQ(law.stiffness, 2);
  EXPECT_EQ(law.friction, 3);
  const std::vector<hair::StripContact> contacts = get_strip_contacts(reader);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].point, 1);
  EXPECT_EQ(contacts[0].corners, contact.corners);
  EXPECT_EQ(contacts[0].shares, contact.shares);
  EXPECT_EQ(contacts[0].normal, contact.normal);
  EXPECT_EQ(contacts[0].weight, 11);
  reader.expect_end();
}

TEST(MeshMessage, RefusesListsThatAreNone) {
  for (const int count : {-1, 3, 2000000000}) {
    MessageWriter message;
    message.put(count);
    MessageReader links(message.bytes()), frames(message.bytes()), contacts(message.bytes());
    EXPECT_THROW(get_static_links(links), MalformedMessage) << count;
    EXPECT_THROW(get_particle_frames(frames), MalformedMessage) << count;
    EXPECT_THROW(get_strip_contacts(contacts), MalformedMessage) << count;
  }
}

}  // namespace
}  // namespace grader
