// Bodies moved apart, each with films of its own.
#pragma once

#include "picture/content.h"
#include "scene/scene.h"

namespace lamella::picture {

struct Exploded {
  scene::Scene
      scene;        // the film with the columns that pictures look at; both regions of a facet are its body
  Content content;  // as given, for the rows of this scene; not exploded any more
};

// Each body is moved from the middle of the bodies by `content.explode` times its distance from there. A film
// between two bodies is drawn twice; films and wires without a body stay.
Exploded explode(const scene::Scene& scene, const Content& content);

// The mean of a body's surface, and of all surfaces that bound no body or each other's (region 0).
std::vector<film::Vec3> body_centres(const scene::Scene& scene);
// The same after `explode`.
std::vector<film::Vec3> exploded_centres(const scene::Scene& scene, double amount);

}  // namespace lamella::picture
