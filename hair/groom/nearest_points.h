// Finds the nearest of many points: a k-d tree. Source: J. Bentley, "Multidimensional Binary Search Trees
// Used for Associative Searching", Communications of the ACM 18 (1975).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hair {

class NearestPoints {
 public:
  // Points are finite; several may be at the same place.
  explicit NearestPoints(std::vector<Eigen::Vector3d> points);

  struct Found {
    long index = -1;  // -1: there is no point, or only `except`
    double distance = 0;
  };
  Found nearest(const Eigen::Vector3d& to, long except = -1) const;

 private:
  // A node is the middle of its range in order_; its halves are the nodes below it.
  void build(std::size_t begin, std::size_t end);
  void search(std::size_t begin, std::size_t end, const Eigen::Vector3d& to, long except, Found& best) const;

  std::vector<Eigen::Vector3d> points_;
  std::vector<std::size_t> order_;
  std::vector<unsigned char> axis_;  // for each node: the axis of its box's longest side
};

}  // namespace hair
