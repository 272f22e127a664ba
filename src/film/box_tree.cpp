#include "film/box_tree.h"

#include <algorithm>
#include <numeric>

namespace lamella::film {

namespace {

constexpr std::uint32_t leaf_size = 4;

}  // namespace

Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

Box box_of(std::span<const Vec3> points, double margin) {
  Box box{points[0], points[0]};
  for (const Vec3& p : points) box = joined(box, {p, p});
  const Vec3 m{margin, margin, margin};
  return {box.low - m, box.high + m};
}

BoxTree::BoxTree(std::span<const Box> boxes) : order_(boxes.size()) {
  if (boxes.empty()) return;
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(boxes.size());
  nodes_.emplace_back();
  divide(boxes, 0, 0, static_cast<std::uint32_t>(boxes.size()));
  boxes_.reserve(boxes.size());
  for (const std::uint32_t i : order_) boxes_.push_back(boxes[i]);
}

void BoxTree::divide(std::span<const Box> boxes, std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
  Box whole = boxes[order_[begin]];
  const auto centre = [&](std::uint32_t i) { return boxes[i].low + boxes[i].high; };
  Box centres{centre(order_[begin]), centre(order_[begin])};
  for (std::uint32_t i = begin; i < end; ++i) {
    whole = joined(whole, boxes[order_[i]]);
    centres = joined(centres, {centre(order_[i]), centre(order_[i])});
  }
  nodes_[node].box = whole;
  if (end - begin <= leaf_size) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const Vec3 size = centres.high - centres.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return centre(a)[axis] < centre(b)[axis]; });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = child;
  nodes_.resize(nodes_.size() + 2);
  divide(boxes, child, begin, middle);
  divide(boxes, child + 1, middle, end);
}

}  // namespace lamella::film
