#include "solve/newton_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "solve/rigid_motion.h"

namespace lamella::solve {

namespace {

// Solutions are mended until they leave no more than this of the right-hand side, or as far as that goes:
// each pass must leave a part of what was left, and the end be fair.
constexpr double accurate = 1e-11;
constexpr double fair = 1e-3;
constexpr double shrinking = 0.7;
constexpr int most_refinements = 12;

using Small = Eigen::Map<const Eigen::MatrixXd>;
using Vector = Eigen::Map<const Eigen::VectorXd>;

double squared(std::span<const double> v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return sum;
}

Eigen::Index index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

std::vector<Vec3> places(const film::Film& film, const Basis& basis) {
  std::vector<Vec3> result;
  result.reserve(basis.size());
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v)
    result.insert(result.end(), basis.count(v), film.position(film::Vertex(v)));
  return result;
}

}  // namespace

NewtonSystem::NewtonSystem(Problem& problem, const film::Film& film, MotionKind motion,
                           SymbolicMemory* memory)
    : problem_(problem),
      film_(film),
      basis_(film, problem.weights(), motion, problem.energy().constraints()),
      hessian_(problem, film, basis_),
      factor_(std::make_unique<SparseFactor>(hessian_.matrix(), places(film, basis_), memory)),
      field_(film.vertex_rows()),
      force_(basis_.size()) {
  film_.edit_position_rows() = {};
}

double NewtonSystem::linearise(std::span<const Vec3> x, bool& ok) {
  const double energy = problem_.linearise(x, ok);
  if (!ok) return energy;
  basis_.renew(x, problem_.energy().constraints());
  if (!problem_.parameters().empty()) parameters_ = parameter_border(problem_, basis_, x, ok);
  return finish_linearise(x, energy);
}

double NewtonSystem::linearise_nearby(std::span<const Vec3> x, bool& ok) {
  const double energy = problem_.linearise(x, ok);
  if (ok && !problem_.parameters().empty()) parameters_ = parameter_border(problem_, basis_, x, ok);
  return ok ? finish_linearise(x, energy) : energy;
}

double NewtonSystem::finish_linearise(std::span<const Vec3> x, double energy) {
  x_.assign(x.begin(), x.end());
  problem_.descent_direction(field_);
  hessian_.assemble(problem_, basis_, x);
  basis_.reduce(field_, force_);
  scale_ = problem_.energy().area() > 0 ? 4 * M_PI / problem_.energy().area() : 1;
  rigid_known_ = bordered_ = false;
  return energy;
}

bool NewtonSystem::factorise(double shift) {
  bordered_ = false;
  hessian_.set_shift(shift);
  return basis_.size() == 0 || factor_->factorise(hessian_.matrix());
}

const std::vector<std::vector<double>>& NewtonSystem::rigid() {
  if (!rigid_known_) rigid_ = rigid_motions(problem_, film_, basis_, hessian_, x_);
  rigid_known_ = true;
  return rigid_;
}

// What stands in the border's own square. The shift acts on parameters as on modes of the size of what stands
// there.
double NewtonSystem::border_square(std::size_t a, std::size_t b) const {
  const std::size_t rigid = rigid_.size();
  if (a < rigid || b < rigid) return 0;
  const double own = parameters_.square[(a - rigid) * parameters_.size() + b - rigid];
  return a == b ? own + hessian_.shift() / scale_ * std::abs(own) : own;
}

void NewtonSystem::border() {
  if (bordered_) return;
  bordered_ = true;
  const std::size_t count = rigid().size() + parameters_.size();
  const std::size_t rows = hessian_.unknowns() + hessian_.constraints();
  columns_.assign(count * rows, 0.0);
  for (std::size_t c = 0; c < rigid_.size(); ++c) {
    for (std::size_t i = 0; i < hessian_.unknowns(); ++i)
      columns_[c * rows + i] = hessian_.mass()[i] * rigid_[c][i];
  }
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    std::copy(parameters_.columns[k].begin(), parameters_.columns[k].end(),
              columns_.begin() + static_cast<std::ptrdiff_t>((rigid_.size() + k) * rows));
  solved_ = columns_;
  if (count > 0) factor_->solve(solved_, static_cast<int>(count));
  gram_.assign(count * count, 0.0);
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) {
      double sum = -border_square(a, b);
      for (std::size_t i = 0; i < rows; ++i) sum += columns_[a * rows + i] * solved_[b * rows + i];
      gram_[a * count + b] = sum;
    }
  }
}

int NewtonSystem::negative_modes_with_rigid() const {
  if (basis_.size() == 0) return 0;
  return std::max(0, factor_->negative_pivots() - static_cast<int>(hessian_.constraints()));
}

std::size_t NewtonSystem::mode_count() const {
  const std::size_t free = basis_.free_size();
  return free - std::min(free, hessian_.constraints());
}

// Bordering a symmetric matrix A by columns C (and a square D) adds the inertia of D - C^T A^-1 C to its own,
// and each independent rigid column takes one negative and one positive eigenvalue for itself.
int NewtonSystem::negative_modes() {
  const int negative = negative_modes_with_rigid();
  if (negative <= 0 && parameters_.size() == 0) return 0;
  border();
  const std::size_t count = rigid_.size() + parameters_.size();
  if (count == 0) return negative;
  const Small gram(gram_.data(), index(count), index(count));
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(gram).eigenvalues();
  const int positive = static_cast<int>(count) - static_cast<int>((values.array() < 0).count());
  return negative + positive - static_cast<int>(rigid_.size());
}

// Solves with the factorisation and mends what is left of the right-hand side, as long as that shrinks.
bool NewtonSystem::solve_refined(std::span<const double> right, std::span<double> solution) {
  std::copy(right.begin(), right.end(), solution.begin());
  factor_->solve(solution, 1);
  std::vector<double> left(right.size());
  const double whole = squared(right);
  double before = HUGE_VAL;
  for (int pass = 0; pass < most_refinements; ++pass) {
    hessian_.multiply(solution, left);
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = right[i] - left[i];
    const double wrong = squared(left);
    if (wrong <= accurate * accurate * whole) return true;
    if (!(wrong < shrinking * shrinking * before)) return wrong <= fair * fair * whole;
    before = wrong;
    factor_->solve(left, 1);
    for (std::size_t i = 0; i < left.size(); ++i) solution[i] += left[i];
  }
  return true;
}

double NewtonSystem::step(std::span<double> reduced) {
  const std::size_t unknowns = hessian_.unknowns();
  const std::size_t rows = unknowns + hessian_.constraints();
  std::vector<double> right(rows, 0.0);
  std::copy(force_.begin(), force_.end(), right.begin());
  std::vector<double> solution(rows);
  if (!solve_refined(right, solution)) return NAN;
  border();
  parameter_step_.assign(parameters_.size(), 0);
  if (const std::size_t count = rigid_.size() + parameters_.size(); count > 0) {
    Eigen::VectorXd part(index(count));
    for (std::size_t c = 0; c < count; ++c) {
      double sum = c < rigid_.size() ? 0 : -parameters_.force[c - rigid_.size()];
      for (std::size_t i = 0; i < rows; ++i) sum += columns_[c * rows + i] * solution[i];
      part[index(c)] = sum;
    }
    const Eigen::VectorXd take = Small(gram_.data(), index(count), index(count)).fullPivLu().solve(part);
    for (std::size_t c = 0; c < count; ++c) {
      for (std::size_t i = 0; i < rows; ++i) solution[i] -= take[index(c)] * solved_[c * rows + i];
      if (c >= rigid_.size()) parameter_step_[c - rigid_.size()] = take[index(c)];
    }
  }
  std::copy_n(solution.begin(), unknowns, reduced.begin());
  double slope = 0;
  for (std::size_t i = 0; i < unknowns; ++i) slope -= force_[i] * reduced[i];
  for (std::size_t k = 0; k < parameters_.size(); ++k) slope -= parameters_.force[k] * parameter_step_[k];
  return slope;
}

}  // namespace lamella::solve
