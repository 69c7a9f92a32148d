// STAFF ONLY.
#include "grader/wire/link_message.h"

#include <Eigen/Core>

namespace grader {
namespace {

using hair::Link, hair::LinkPass;

// What a link and a pass are made of, one after the other, for those who put and for those who get.

template <typename Numbers, typename Visit>
void visit(Numbers& motion, Visit one) requires requires {
  motion.angular;
}
{
  one(motion.angular);
  one(motion.linear);
}
template <typename Numbers, typename Visit>
void visit(Numbers& force, Visit one) requires requires {
  force.torque;
}
{
  one(force.force);
  one(force.torque);
}
template <typename Numbers, typename Visit>
void visit(Numbers& inertia, Visit one) requires requires {
  inertia.H;
}
{
  one(inertia.M);
  one(inertia.H);
  one(inertia.J);
}
template <typename Numbers, typename Visit>
void visit(Numbers& link, Visit one) requires requires {
  link.tensor;
}
{
  one(link.u);
  one(link.d);
  one(link.r);
  one(link.tensor);
  visit(link.external, one);
  visit(link.inertia, one);
  one(link.stiffening);
}
template <typename Numbers, typename Visit>
void visit(Numbers& pass, Visit one) requires requires {
  pass.gain;
}
{
  visit(pass.v, one);
  visit(pass.c, one);
  visit(pass.bias, one);
  visit(pass.inertia, one);
  one(pass.gain);
  visit(pass.a, one);
}

template <typename Numbers>
std::vector<double> numbers_of(const Numbers& whole) {
  std::vector<double> numbers;
  visit(whole,
        [&](const auto& part) { numbers.insert(numbers.end(), part.data(), part.data() + part.size()); });
  return numbers;
}

template <typename Numbers>
Numbers from(MessageReader& message) {
  Numbers whole;
  const std::vector<double> numbers = message.get_doubles(numbers_of(whole).size());
  const double* at = numbers.data();
  visit(whole, [&](auto& part) {
    std::copy(at, at + part.size(), part.data());
    at += part.size();
  });
  return whole;
}

}  // namespace

void put(MessageWriter& message, const std::vector<Link>& links) {
  message.put(static_cast<int>(links.size()));
  for (const Link& link : links) {
    message.put(link.parent).put(static_cast<int>(link.joint)).put(link.first);
    message.put(std::span<const double>(numbers_of(link)));
  }
}

void put(MessageWriter& message, const std::vector<LinkPass>& passes) {
  for (const LinkPass& pass : passes) message.put(std::span<const double>(numbers_of(pass)));
}

std::vector<Link> get_links(MessageReader& message, int& rates) {
  const int count = message.get<int>();
  if (count < 1) throw MalformedMessage("a tree of links without its base");
  std::vector<Link> links;
  rates = 0;
  for (int i = 0; i < count; ++i) {
    const int parent = message.get<int>(), joint = message.get<int>(), first = message.get<int>();
    if (parent < 0 || parent > std::max(0, i - 1)) throw MalformedMessage("a link whose parent comes later");
    if (joint < 0 || joint > static_cast<int>(hair::JointType::spherical))
      throw MalformedMessage("an unknown type of joint");
    if (first != rates) throw MalformedMessage("rates that are not in the order of their links");
    Link link = from<Link>(message);
    link.parent = parent;
    link.joint = static_cast<hair::JointType>(joint);
    link.first = first;
    if (i > 0) rates += hair::rates_of(link.joint);
    links.push_back(link);
  }
  return links;
}

std::vector<LinkPass> get_passes(MessageReader& message, std::size_t links) {
  std::vector<LinkPass> passes;
  for (std::size_t i = 0; i < links; ++i) passes.push_back(from<LinkPass>(message));
  return passes;
}

}  // namespace grader
