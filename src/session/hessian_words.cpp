#include "session/hessian_words.h"

namespace lamella::session {

namespace {

using solve::Ending;

std::span<film::Vec3> film_of(Session& session) {
  if (session.scene().empty())
    throw text::Error("there is no film to move", "load a datafile first: load \"cube.fe\"");
  return session.scene().film.edit_positions();
}

}  // namespace

HessianWork::HessianWork(Session& session)
    : session_(session),
      problem_((film_of(session), session.scene())),
      x_(session.scene().film.edit_positions()),
      method_(problem_, session.scene().film,
              session.scene().hessian_normal ? solve::MotionKind::normal : solve::MotionKind::full,
              &session.memory<solve::SymbolicMemory>()) {
  double energy = 0;
  const Ending ending = problem_.linearise_and_restore(x_, energy);
  if (ending != Ending::converged) refuse_hessian_step(ending);
}

void HessianWork::linearise() {
  bool ok = false;
  method_.system().linearise(x_, ok);
  if (!ok) refuse_hessian_step(Ending::volume_lost);
}

void refuse_hessian_step(Ending ending) {
  throw text::Error(std::string(solve::describe(ending)),
                    ending == Ending::not_finite
                        ? "look for degenerate facets: list facets where area < 1e-12"
                        : "g or relax may get nearer to an equilibrium first");
}

void tell_negative_modes(Session& session, const solve::NewtonStep& step) {
  session.counter("residual") = step.residual;
  session.counter("negative_modes") = step.negative_modes;
  if (step.negative_modes == 0) return;
  session.tell("Hessian is not positive definite: {} negative mode{}.\n", step.negative_modes,
               step.negative_modes == 1 ? "" : "s");
}

}  // namespace lamella::session
