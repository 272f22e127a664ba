#include "air/air_flow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include <fftw3.h>

namespace lamella::air {

namespace {

using Complex = std::complex<double>;

struct FreeFftw {
  void operator()(void* memory) const { fftw_free(memory); }
};

// Velocities of one axis and their transform, in one piece of memory, with the plans between them. Planned
// without trials, so that the same flow is computed on every run.
class Component {
 public:
  explicit Component(int cells)
      : reals_(fftw_alloc_real(padded(cells))),
        forward_(fftw_plan_dft_r2c_3d(cells, cells, cells, reals_.get(), modes(), FFTW_ESTIMATE)),
        backward_(fftw_plan_dft_c2r_3d(cells, cells, cells, modes(), reals_.get(), FFTW_ESTIMATE)) {}
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  ~Component() {
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(backward_);
  }

  double* reals() { return reals_.get(); }
  Complex* complex() { return reinterpret_cast<Complex*>(reals_.get()); }
  void transform() { fftw_execute(forward_); }
  void transform_back() { fftw_execute(backward_); }

 private:
  static std::size_t padded(int cells) {
    const auto n = static_cast<std::size_t>(cells);
    return n * n * 2 * (n / 2 + 1);
  }
  fftw_complex* modes() { return reinterpret_cast<fftw_complex*>(reals_.get()); }

  std::unique_ptr<double, FreeFftw> reals_;
  fftw_plan forward_;
  fftw_plan backward_;
};

void bind(std::optional<scene::VectorFormula>& formula, const language::Variables& variables) {
  if (!formula) return;
  for (language::Formula& component : formula->component) component.bind(variables);
}

Vec3 value(const scene::VectorFormula& formula, const Vec3& at, double time) {
  const std::array<double, 3> place{at.x, at.y, at.z};
  const std::array<double, 6> still{};
  const language::FormulaInputs inputs{place, time, still};
  return {formula.component[0].value(inputs), formula.component[1].value(inputs),
          formula.component[2].value(inputs)};
}

}  // namespace

struct AirFlow::Work {
  scene::Air air;
  Vec3 width;  // of a cell
  std::vector<Vec3> velocity;
  std::vector<Vec3> before;
  std::array<Component, 3> components;

  Work(const scene::Air& given, const language::Variables& variables)
      : air(given),
        width((1.0 / given.cells) * (given.to - given.from)),
        components{Component(given.cells), Component(given.cells), Component(given.cells)} {
    const auto n = static_cast<std::size_t>(air.cells);
    if (air.velocity && air.velocity->size() == n * n * n) velocity = *air.velocity;
    velocity.resize(n * n * n);
    bind(air.fan, variables);
    bind(air.jet, variables);
  }

  template <class Function>
  void for_each_cell(Function&& function) const {
    std::size_t cell = 0;
    for (int k = 0; k < air.cells; ++k) {
      for (int j = 0; j < air.cells; ++j) {
        for (int i = 0; i < air.cells; ++i, ++cell) {
          const Vec3 middle{(i + 0.5) * width.x, (j + 0.5) * width.y, (k + 0.5) * width.z};
          function(cell, air.from + middle);
        }
      }
    }
  }

  Vec3 sample(const std::vector<Vec3>& field, const Vec3& point) const;
  double own_step() const;
  void stir(double dt);
  void carry(double dt);
  void project(double dt);
};

Vec3 AirFlow::Work::sample(const std::vector<Vec3>& field, const Vec3& point) const {
  const auto n = static_cast<std::size_t>(air.cells);
  std::array<std::size_t, 3> low{};
  std::array<double, 3> part{};
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = (point[axis] - air.from[axis]) / width[axis] - 0.5;
    const double floor = std::floor(cell);
    const double turn = std::floor(floor / air.cells);
    const auto a = static_cast<std::size_t>(axis);
    low[a] = std::min(n - 1, static_cast<std::size_t>(floor - turn * air.cells));
    part[a] = cell - floor;
  }
  Vec3 sum;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    std::array<std::size_t, 3> at{};
    double weight = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t up = (corner >> a) & 1U;
      at[a] = (low[a] + up) % n;
      weight *= up == 1 ? part[a] : 1 - part[a];
    }
    sum += weight * field[(at[2] * n + at[1]) * n + at[0]];
  }
  return sum;
}

double AirFlow::Work::own_step() const {
  double fastest = 1;
  for (const Vec3& v : velocity) fastest = std::max(fastest, length(v));
  return 0.5 * std::min({width.x, width.y, width.z}) / fastest;
}

// Fans and jets.
void AirFlow::Work::stir(double dt) {
  if (!air.fan && !air.jet) return;
  for_each_cell([&](std::size_t cell, const Vec3& at) {
    if (air.fan) velocity[cell] += dt * value(*air.fan, at, air.time);
    if (!air.jet) return;
    const Vec3 jet = value(*air.jet, at, air.time);
    if (jet != Vec3{}) velocity[cell] = jet;
  });
}

// Each cell takes over what was where its air comes from.
void AirFlow::Work::carry(double dt) {
  before = velocity;
  for_each_cell([&](std::size_t cell, const Vec3& at) {
    const Vec3 halfway = at - 0.5 * dt * before[cell];
    velocity[cell] = sample(before, at - dt * sample(before, halfway));
  });
}

// Viscosity, and what is left without divergence.
void AirFlow::Work::project(double dt) {
  const int n = air.cells;
  const auto size = static_cast<std::size_t>(n);
  const std::size_t row = 2 * (size / 2 + 1);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t line = 0; line < size * size; ++line) {
      for (std::size_t i = 0; i < size; ++i)
        components[a].reals()[line * row + i] = velocity[line * size + i][static_cast<int>(a)];
    }
    components[a].transform();
  }
  const auto wave = [&](int index, double cell) {
    const int signed_index = 2 * index < n ? index : index - n;
    return 2 * index == n ? 0.0 : 2 * M_PI * signed_index / (n * cell);
  };
  std::size_t mode = 0;
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i <= n / 2; ++i, ++mode) {
        const Vec3 q{wave(i, width.x), wave(j, width.y), wave(k, width.z)};
        const double squared = squared_length(q);
        std::array<Complex, 3> u;
        for (std::size_t a = 0; a < 3; ++a) u[a] = components[a].complex()[mode];
        const Complex along = squared > 0 ? (q.x * u[0] + q.y * u[1] + q.z * u[2]) / squared : Complex{};
        const double kept = std::exp(-air.viscosity * squared * dt) / static_cast<double>(size * size * size);
        for (std::size_t a = 0; a < 3; ++a)
          components[a].complex()[mode] = kept * (u[a] - q[static_cast<int>(a)] * along);
      }
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    components[a].transform_back();
    for (std::size_t line = 0; line < size * size; ++line) {
      for (std::size_t i = 0; i < size; ++i)
        velocity[line * size + i][static_cast<int>(a)] = components[a].reals()[line * row + i];
    }
  }
}

AirFlow::AirFlow(const scene::Air& air, const language::Variables& variables)
    : work_(std::make_unique<Work>(air, variables)) {}
AirFlow::~AirFlow() = default;
AirFlow::AirFlow(AirFlow&&) noexcept = default;
AirFlow& AirFlow::operator=(AirFlow&&) noexcept = default;

void AirFlow::advance(double time) {
  Work& w = *work_;
  for (double dt = w.own_step(); w.air.time + dt <= time; dt = w.own_step()) {
    w.stir(dt);
    w.carry(dt);
    w.project(dt);
    w.air.time += dt;
  }
}

Vec3 AirFlow::at(const Vec3& point) const {
  return work_->sample(work_->velocity, point);
}

double AirFlow::pressure() const {
  return work_->air.pressure;
}

void AirFlow::store(scene::Air& air) const {
  air.time = work_->air.time;
  air.velocity = std::make_shared<const std::vector<Vec3>>(work_->velocity);
}

}  // namespace lamella::air
