// The part of a film's motion that is a rigid body's, and what a film as a whole keeps of it.
#pragma once

#include <cstdint>
#include <span>

#include "evolution/balance.h"
#include "scene/scene.h"

namespace lamella::evolution {

struct RigidVelocity {
  Vec3 centre;
  Vec3 velocity;
  Vec3 turn;  // radians per unit of time
  Vec3 at(const Vec3& point) const { return velocity + cross(turn, point - centre); }
};

enum class Kept : std::uint8_t { none, momentum, both_momenta };

// Something that holds the film takes its momentum; in periodic space nothing turns.
Kept kept_by(const scene::Scene& scene);

// The velocity field of a rigid body with the same momentum and, where that is kept, angular momentum.
RigidVelocity rigid_velocity(const Balance& whole, std::span<const Vec3> x, std::span<const double> masses,
                             Kept kept);

}  // namespace lamella::evolution
