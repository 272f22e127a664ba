// Pictures of periodic films by what draws plain ones.
#pragma once

#include <utility>

#include "picture/show.h"
#include "picture/unwrap.h"

namespace lamella::picture {

// What `make(scene, options)` gives for the film in which every bubble of a periodic one is whole.
template <class Make>
auto unwrapped(const scene::Scene& scene, const PictureOptions& options, Make&& make) {
  FilmCopy copy = unwrap(scene, options.content);
  copy.scene.name = scene.name;
  copy.scene.time = scene.time;
  PictureOptions plain = options;
  plain.content = std::move(copy.content);
  return make(copy.scene, plain);
}

}  // namespace lamella::picture
