#include "picture/blending.h"

#include <algorithm>
#include <tuple>

namespace lamella::picture {

namespace {

Colour unpack_channels(std::uint32_t packed) {
  const auto channel = [&](int shift) { return static_cast<float>((packed >> shift) & 1023U) / 1023.0F; };
  return {channel(0), channel(10), channel(20)};
}

bool nearer(const Fragment& a, const Fragment& b) {
  return std::tie(a.depth, a.glow, a.clear) < std::tie(b.depth, b.glow, b.clear);
}

}  // namespace

Layer unpack(const Fragment& fragment) {
  const Colour root = unpack_channels(fragment.glow);
  return {4.0F * (root * root), unpack_channels(fragment.clear)};
}

Layer Blender::blend(std::span<const Fragment> fragments, std::uint32_t first) {
  sorted_.clear();
  for (std::uint32_t i = first; i != Fragment::end_of_list; i = fragments[i].next) {
    // Insertion: lists are short, and often in order already.
    const Fragment& added = fragments[i];
    std::size_t at = sorted_.size();
    sorted_.push_back(added);
    while (at > 0 && nearer(added, sorted_[at - 1])) {
      sorted_[at] = sorted_[at - 1];
      --at;
    }
    sorted_[at] = added;
  }
  Layer seen;
  for (const Fragment& fragment : sorted_) seen = over(seen, unpack(fragment));
  return seen;
}

}  // namespace lamella::picture
