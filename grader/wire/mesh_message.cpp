// STAFF ONLY.
#include "grader/wire/mesh_message.h"

#include <algorithm>

#include "grader/wire/helix_message.h"

namespace grader {
namespace {

constexpr int kMost = 100000;  // of anything in a list

void put(MessageWriter& message, const hair::Matrix3d& frame) {
  message.put(std::span<const double>(frame.data(), 9));
}

template <class Item>
void put_list(MessageWriter& message, std::span<const Item> items) {
  message.put(static_cast<int>(items.size()));
  for (const Item& item : items) put(message, item);
}

template <class Item>
std::vector<Item> get_list(MessageReader& message, Item (*get)(MessageReader&)) {
  const int count = message.get<int>();
  if (count < 0 || count > kMost) throw MalformedMessage("a list of too many items, or of fewer than none");
  std::vector<Item> items;  // grows with what is really there
  for (int i = 0; i < count; ++i) items.push_back(get(message));
  return items;
}

hair::Matrix3d get_particle_frame(MessageReader& message) {
  return Eigen::Map<const hair::Matrix3d>(message.get_doubles(9).data());
}

}  // namespace

void put(MessageWriter& message, const hair::StaticLink& link) {
  message.put(link.a).put(link.b);
  put_vector3(message, link.offset);
  message.put(link.length).put(link.stiffness).put(link.yields).put(link.breaks);
}

void put(MessageWriter& message, std::span<const hair::StaticLink> links) {
  put_list(message, links);
}

void put(MessageWriter& message, std::span<const hair::Matrix3d> frames) {
  put_list(message, frames);
}

void put(MessageWriter& message, const hair::StripLaw& law) {
  message.put(law.thickness).put(law.stiffness).put(law.friction);
}

void put(MessageWriter& message, const hair::StripContact& contact) {
  message.put(contact.point);
  for (const int corner : contact.corners) message.put(corner);
  message.put(std::span<const double>(contact.shares));
  put_vector3(message, contact.normal);
  message.put(contact.weight);
}

void put(MessageWriter& message, std::span<const hair::StripContact> contacts) {
  put_list(message, contacts);
}

hair::StaticLink get_static_link(MessageReader& message) {
  hair::StaticLink link;
  link.a = message.get<int>();
  link.b = message.get<int>();
  link.offset = get_vector3(message);
  for (double* number : {&link.length, &link.stiffness, &link.yields, &link.breaks})
    *number = message.get<double>();
  return link;
}

std::vector<hair::StaticLink> get_static_links(MessageReader& message) {
  return get_list(message, get_static_link);
}

std::vector<hair::Matrix3d> get_particle_frames(MessageReader& message) {
  return get_list(message, get_particle_frame);
}

hair::StripLaw get_strip_law(MessageReader& message) {
  hair::StripLaw law;
  for (double* number : {&law.thickness, &law.stiffness, &law.friction}) *number = message.get<double>();
  return law;
}

hair::StripContact get_strip_contact(MessageReader& message) {
  hair::StripContact contact;
  contact.point = message.get<int>();
  for (int& corner : contact.corners) corner = message.get<int>();
  const std::vector<double> shares = message.get_doubles(3);
  std::copy(shares.begin(), shares.end(), contact.shares.begin());
  contact.normal = get_vector3(message);
  contact.weight = message.get<double>();
  return contact;
}

std::vector<hair::StripContact> get_strip_contacts(MessageReader& message) {
  return get_list(message, get_strip_contact);
}

}  // namespace grader
