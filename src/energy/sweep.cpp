#include "energy/sweep.h"

#include <algorithm>
#include <cmath>

#include "energy/lanes.h"

namespace lamella::energy {

namespace {

using Corners = std::array<film::Vertex, 3>;

// Four triangles side by side, as they lie in memory. The last batch of a film may hold fewer: it is a copy,
// whose spare lanes repeat a triangle with weight 0.
struct Batch {
  const Corners* corners;
  const film::RegionPair* regions;
  Lane tension;
  Lane weight;
  std::uint32_t first;  // of its triangles
};

constexpr Lane ones{1, 1, 1, 1};

Batch full_batch(const SweepInput& input, std::size_t first) {
  const film::RegionPair* const regions = input.has_regions ? input.regions.data() + first : nullptr;
  Batch batch{input.triangles.data() + first, regions, ones, ones, static_cast<std::uint32_t>(first)};
  if (!input.tension.empty()) std::memcpy(&batch.tension, input.tension.data() + first, sizeof batch.tension);
  return batch;
}

struct PartBatch {
  std::array<Corners, lanes> corners;
  std::array<film::RegionPair, lanes> regions;
  Batch batch;
};

PartBatch last_batch(const SweepInput& input, std::size_t first) {
  PartBatch part{};
  part.batch.first = static_cast<std::uint32_t>(first);
  for (std::size_t i = 0; i < lanes; ++i) {
    const bool spare = first + i >= input.triangles.size();
    const std::size_t t = spare ? first : first + i;
    part.corners[i] = input.triangles[t];
    if (input.has_regions) part.regions[i] = input.regions[t];
    part.batch.weight[i] = spare ? 0.0 : 1.0;
    part.batch.tension[i] = spare ? 0.0 : input.tension.empty() ? 1.0 : input.tension[t];
  }
  return part;
}

// Calls function(one) for each batch, or function(one, next) for two of them where there are two: a batch
// waits for roots and quotients, and another one has work meanwhile.
template <class Function>
void for_each_batch(const SweepInput& input, SweepPlan::Range range, Function&& function) {
  std::size_t first = range.first;
  for (; first + 2 * lanes <= range.last; first += 2 * lanes)
    function(full_batch(input, first), full_batch(input, first + lanes));
  for (; first + lanes <= range.last; first += lanes) function(full_batch(input, first));
  if (first < range.last) {
    PartBatch part = last_batch(input, first);
    part.batch.corners = part.corners.data();
    part.batch.regions = part.regions.data();
    function(part.batch);
  }
}

Lane3 gather(const SweepInput& input, const Batch& batch, std::size_t corner) {
  std::array<Lane, lanes> p;
  for (std::size_t i = 0; i < lanes; ++i) p[i] = load(input.positions, batch.corners[i][corner].index);
  const std::array<Lane, 4> axes = transposed(p[0], p[1], p[2], p[3]);
  return {axes[0], axes[1], axes[2]};
}

using Words [[gnu::vector_size(lanes * sizeof(std::int64_t))]] = std::int64_t;

// The pairs of regions of a batch, each as one number.
Words words(const Batch& batch) {
  static_assert(sizeof(film::RegionPair) == sizeof(std::int64_t));
  Words w;
  std::memcpy(&w, batch.regions, sizeof w);
  return w;
}

// +1 where the normal points into the region of lower number, -1 into the higher, 0 where both are the same.
Lane orientations(const Batch& batch) {
  const Words pairs = words(batch);
  const Words front = pairs & 0xffffffff;
  const Words behind = (pairs >> 32) & 0xffffffff;
  const Lane into_lower = front < behind ? ones : Lane{};
  return front > behind ? -ones : into_lower;
}

// Adds the tetrahedra under the triangles to the volumes of the regions behind and takes them from those in
// front. Neighbours in memory mostly part the same two regions, so a run is summed in lanes.
class VolumeSum {
 public:
  explicit VolumeSum(std::span<double> volumes) : volumes_(volumes) {
    std::fill(volumes_.begin(), volumes_.end(), 0.0);
  }
  VolumeSum(const VolumeSum&) = delete;
  VolumeSum& operator=(const VolumeSum&) = delete;
  ~VolumeSum() { flush(); }

  void add(const Batch& batch, const Lane& sixfold) {
    const Words pairs = words(batch);
    if (((pairs[0] ^ pairs[1]) | (pairs[0] ^ pairs[2]) | (pairs[0] ^ pairs[3])) == 0) {
      if (!(batch.regions[0] == run_)) {
        flush();
        run_ = batch.regions[0];
      }
      sum_ += sixfold;
      return;
    }
    const Lane volume = (1.0 / 6) * sixfold;
    for (std::size_t i = 0; i < lanes; ++i) {
      volumes_[batch.regions[i].behind.index] += volume[i];
      volumes_[batch.regions[i].front.index] -= volume[i];
    }
  }

 private:
  void flush() {
    const double volume = sum(sum_) / 6;
    if (volumes_.empty()) return;
    volumes_[run_.behind.index] += volume;
    volumes_[run_.front.index] -= volume;
    sum_ = Lane{};
  }

  std::span<double> volumes_;
  film::RegionPair run_;
  Lane sum_{};
};

Lane3 relative(const Lane3& p, const Vec3& origin) {
  return {p.x - origin.x, p.y - origin.y, p.z - origin.z};
}

// What the sums over a part of the film are made of.
struct Sums {
  explicit Sums(std::span<double> volumes) : volume(volumes) {}
  SweepSums whole() const { return {0.5 * sum(energy), 0.5 * sum(area)}; }

  Lane energy{};  // twice
  Lane area{};    // twice
  VolumeSum volume;
};

// What four triangles give to their corners: values of each corner's own, and values that all three share.
struct Shares {
  std::array<Lane3, 3> gradient;
  Lane stiffness;
  Lane3 area_vector;
  Lane area;
};

constexpr double least_square = 1e-300;

template <bool with_regions>
[[gnu::always_inline]] inline Shares shares_of(const SweepInput& input, const Batch& batch, Sums& sums) {
  const Lane3 a = gather(input, batch, 0);
  const Lane3 b = gather(input, batch, 1);
  const Lane3 c = gather(input, batch, 2);
  const Lane3 ab = b - a;
  const Lane3 bc = c - b;
  const Lane3 ca = a - c;
  const Lane3 normal = cross(ca, ab);  // twice the vector area
  const Lane square = dot(normal, normal);
  // The root and the quotient do not wait for one another.
  const Lane doubled = square_root(square);
  const Lane per_square = 1.0 / (square > least_square ? square : ones);  // no area, no gradient
  sums.energy += batch.tension * doubled;
  sums.area += batch.weight * doubled;

  Shares shares;
  const Lane half = 0.5 * (doubled * per_square);
  const Lane sides = dot(ab, ab) + dot(bc, bc) + dot(ca, ca);
  const Lane under = (0.25 * per_square) * (sides * sides) - 3.0;
  shares.stiffness = 0.5 * batch.tension * (sides * half + square_root(under > 0 ? under : Lane{}));
  shares.area = (1.0 / 6) * doubled * batch.weight;
  shares.area_vector = Lane3{};
  if constexpr (with_regions) {
    shares.area_vector = normal * ((1.0 / 6) * orientations(batch) * batch.weight);
    sums.volume.add(batch, dot(normal, relative(a, input.origin)) * batch.weight);
  }
  const Lane3 pull = normal * (batch.tension * half);
  shares.gradient = {cross(pull, bc), cross(pull, ca), cross(pull, ab)};
  return shares;
}

// What the corners of a range of triangles at borders collect.
class BorderSum {
 public:
  BorderSum(const SweepInput& input, SweepPlan::Range range) : slots_(input.slots) {
    const auto before = [](const BorderCorner& corner, std::uint32_t t) { return corner.triangle < t; };
    const auto first = std::lower_bound(input.corners.begin(), input.corners.end(), range.first, before);
    next_ = input.corners.data() + (first - input.corners.begin());
    end_ = input.corners.data() + input.corners.size();
  }
  // The area vectors of a batch, batch after batch.
  void add(const Batch& batch, const std::array<Lane, lanes>& vectors) {
    for (; next_ != end_ && next_->triangle < batch.first + lanes; ++next_) {
      const Lane& vector = vectors[next_->triangle - batch.first];
      if (next_->higher != BorderCorner::none) add_to(&slots_[next_->higher].gradient.x, vector);
      if (next_->lower != BorderCorner::none) add_to(&slots_[next_->lower].gradient.x, -vector);
    }
  }

 private:
  std::span<VolumeSlot> slots_;
  const BorderCorner* next_;
  const BorderCorner* end_;
};

[[gnu::always_inline]] inline void scatter(const Batch& batch, const Shares& shares, BorderSum& border,
                                           std::span<VertexLine> lines) {
  const std::array<Lane, 4> common =
      transposed(shares.area_vector.x, shares.area_vector.y, shares.area_vector.z, shares.area);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Lane3& g = shares.gradient[corner];
    const std::array<Lane, 4> own = transposed(g.x, g.y, g.z, shares.stiffness);
    for (std::size_t i = 0; i < lanes; ++i) {
      VertexLine& line = lines[batch.corners[i][corner].index];
      add_to(&line.gradient.x, own[i]);
      add_to(&line.area_vector.x, common[i]);
    }
  }
  border.add(batch, common);
}

template <bool with_regions>
void add_gradients(const SweepInput& input, SweepPlan::Range range, Sums& sums, std::span<VertexLine> lines) {
  BorderSum border(input, range);
  for_each_batch(input, range, [&](const auto&... batches) {
    const std::array<Shares, sizeof...(batches)> shares{shares_of<with_regions>(input, batches, sums)...};
    std::size_t i = 0;
    (scatter(batches, shares[i++], border, lines), ...);
  });
}

template <bool with_regions>
void add_energies(const SweepInput& input, SweepPlan::Range range, Sums& sums) {
  const auto add = [&](const Batch& batch) {
    const Lane3 a = gather(input, batch, 0);
    const Lane3 normal = cross(gather(input, batch, 1) - a, gather(input, batch, 2) - a);
    const Lane doubled = square_root(dot(normal, normal));
    sums.energy += batch.tension * doubled;
    sums.area += batch.weight * doubled;
    if constexpr (with_regions) sums.volume.add(batch, dot(normal, relative(a, input.origin)) * batch.weight);
  };
  for_each_batch(input, range, [&](const auto&... batches) { (add(batches), ...); });
}

// Calls add(range, sums) for the triangles of each part of a plan, and at last for what lies between them;
// before(part, rows) and after(part, rows) where rows are met first and last.
template <class Add, class Before, class After>
SweepSums share_out(SweepPlan& plan, std::span<double> volumes, const Add& add, const Before& before,
                    const After& after) {
  const std::size_t parts = plan.size();
  for (const SweepPlan::Range& rows : plan.shared_rows()) before(parts, rows);
#pragma omp parallel for schedule(static) if (parts > 1)
  for (std::size_t i = 0; i < parts; ++i) {
    Sums sums(plan.volumes(i));
    for (const SweepPlan::Stage& stage : plan.stages(i)) {
      for (const SweepPlan::Range& rows : stage.fresh) before(i, rows);
      add(stage.triangles, sums);
      for (const SweepPlan::Range& rows : stage.done) after(i, rows);
    }
    plan.sums(i) = sums.whole();
  }
  {
    Sums sums(plan.volumes(parts));
    for (const SweepPlan::Range& range : plan.between()) add(range, sums);
    plan.sums(parts) = sums.whole();
  }
  after(parts, SweepPlan::Range{0, 1});
  for (const SweepPlan::Range& rows : plan.shared_rows()) after(parts, rows);
  SweepSums whole;
  std::fill(volumes.begin(), volumes.end(), 0.0);
  for (std::size_t i = 0; i <= parts; ++i) {
    whole.energy += plan.sums(i).energy;
    whole.area += plan.sums(i).area;
    for (std::size_t r = 0; r < volumes.size(); ++r) volumes[r] += plan.volumes(i)[r];
  }
  return whole;
}

template <class Add>
SweepSums sweep_all(const SweepInput& input, std::span<double> volumes, const Add& add) {
  Sums sums(volumes);
  add(SweepPlan::Range{0, static_cast<std::uint32_t>(input.triangles.size())}, sums);
  return sums.whole();
}

}  // namespace

double stiffness_bound(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double doubled = film::length(film::cross(b - a, c - a));
  const double ratio =
      (film::squared_length(b - a) + film::squared_length(c - b) + film::squared_length(a - c)) /
      (2 * doubled);
  return 0.5 * (ratio + std::sqrt(std::max(0.0, ratio * ratio - 3)));
}

SweepSums sweep_energy(const SweepInput& input, std::span<double> volumes) {
  const auto add = [&](SweepPlan::Range range, Sums& sums) {
    input.has_regions ? add_energies<true>(input, range, sums) : add_energies<false>(input, range, sums);
  };
  if (input.plan == nullptr) return sweep_all(input, volumes, add);
  const auto nothing = [](std::size_t, SweepPlan::Range) {};
  return share_out(*input.plan, volumes, add, nothing, nothing);
}

SweepSums sweep_gradient(const SweepInput& input, std::span<double> volumes, std::span<VertexLine> lines,
                         RowWork* work) {
  const auto add = [&](SweepPlan::Range range, Sums& sums) {
    input.has_regions ? add_gradients<true>(input, range, sums, lines)
                      : add_gradients<false>(input, range, sums, lines);
  };
  std::fill(input.slots.begin(), input.slots.end(), VolumeSlot{});
  if (input.plan == nullptr) {
    std::fill(lines.begin(), lines.end(), VertexLine{});
    return sweep_all(input, volumes, add);
  }
  if (!lines.empty()) lines[0] = {};
  const auto before = [&](std::size_t part, SweepPlan::Range rows) {
    if (work != nullptr) work->before(part, rows.first, rows.last);
    std::fill(lines.data() + rows.first, lines.data() + rows.last, VertexLine{});
  };
  const auto after = [&](std::size_t part, SweepPlan::Range rows) {
    if (work != nullptr) work->after(part, rows.first, rows.last);
  };
  return share_out(*input.plan, volumes, add, before, after);
}

void work_after_sweep(const SweepPlan& plan, RowWork& work) {
  const std::size_t parts = plan.size();
#pragma omp parallel for schedule(static) if (parts > 1)
  for (std::size_t i = 0; i < parts; ++i) {
    for (const SweepPlan::Stage& stage : plan.stages(i)) {
      for (const SweepPlan::Range& rows : stage.done) work.after(i, rows.first, rows.last);
    }
  }
  work.after(parts, 0, 1);
  for (const SweepPlan::Range& rows : plan.shared_rows()) work.after(parts, rows.first, rows.last);
}

}  // namespace lamella::energy
