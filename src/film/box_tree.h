// A tree of boxes, for finding which of many lie near one another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/vec3.h"

namespace lamella::film {

struct Box {
  Vec3 low;
  Vec3 high;

  bool meets(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
           low.z <= other.high.z && other.low.z <= high.z;
  }
};

Box box_of(std::span<const Vec3> points, double margin = 0);
Box joined(const Box& a, const Box& b);

// Built once over a list of boxes, halving each group along its longest axis: n log n.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box> boxes);

  // Calls function(index) for each box of the list that meets another.
  template <class Function>
  void for_each_met(const Box& box, Function&& function) const {
    if (nodes_.empty()) return;
    std::uint32_t stack[64] = {0};
    int depth = 1;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!node.box.meets(box)) continue;
      if (node.count == 0) {
        stack[depth++] = node.first;
        stack[depth++] = node.first + 1;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (boxes_[i].meets(box)) function(order_[i]);
      }
    }
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  // the first child of two, or the first box of a leaf
    std::uint32_t count = 0;  // of boxes in a leaf; 0 for others
  };
  void divide(std::span<const Box> boxes, std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;  // in this order
};

}  // namespace lamella::film
