// Bodies moved apart, each with films of its own.
#pragma once

#include "picture/film_copy.h"
#include "scene/scene.h"

namespace lamella::picture {

// Each body is moved from the middle of the bodies by `content.explode` times its distance from there. A film
// between two bodies is drawn twice, with its body on both sides; films and wires without a body stay.
FilmCopy explode(const scene::Scene& scene, const Content& content);

// The mean of a body's surface, and of all surfaces that bound no body or each other's (region 0).
std::vector<film::Vec3> body_centres(const scene::Scene& scene);
// The same after `explode`.
std::vector<film::Vec3> exploded_centres(const scene::Scene& scene, double amount);

}  // namespace lamella::picture
