// What the commands share that go by second derivatives.
#pragma once

#include "session/session.h"
#include "solve/newton.h"

namespace lamella::session {

// Newton's method at the scene's film, its volumes and constraints restored first. Throws text::Error where
// there is no film, or where they cannot be restored.
class HessianWork {
 public:
  explicit HessianWork(Session& session);

  solve::Newton& method() { return method_; }
  solve::NewtonSystem& system() { return method_.system(); }
  std::span<film::Vec3> positions() { return x_; }

  // Linearises at the present shape. Throws if that fails.
  void linearise();
  // Writes pressures to the bodies.
  void publish() { problem_.publish(session_.scene()); }

 private:
  Session& session_;
  solve::Problem problem_;
  std::span<film::Vec3> x_;
  solve::Newton method_;
};

// Throws what an ending that is no step means.
void refuse_hessian_step(solve::Ending ending);

// "Hessian is not positive definite: 1 negative mode." or nothing; and the variables `residual` and
// `negative_modes`.
void tell_negative_modes(Session& session, const solve::NewtonStep& step);

}  // namespace lamella::session
