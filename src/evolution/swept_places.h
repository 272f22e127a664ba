// Where a motion took its forces last, kept for the motion that goes on from there.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace lamella::evolution {

// A film is left where its volumes are right, a little beside the places where its forces were taken (see
// Motion). They travel in a column of the vertices, and count only as long as the film is where it was left.
void store_swept_places(scene::Scene& scene, std::span<const film::Vec3> places);
// Those places, taken out of the scene; none if the film has been changed since.
std::optional<std::vector<film::Vec3>> take_swept_places(scene::Scene& scene);

}  // namespace lamella::evolution
