#include "energy/sweep.h"

#include <algorithm>
#include <cmath>

#include "energy/lanes.h"
#include "film/blocks.h"

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
};

constexpr Lane ones{1, 1, 1, 1};

Batch full_batch(const SweepInput& input, std::size_t first) {
  Batch batch{input.triangles.data() + first, input.regions.data() + first, ones, ones};
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

using Ranges = std::span<const SweepPlan::Range>;

// Calls function(one) for each batch, or function(one, next) for two of them where there are two: a batch
// waits for roots and quotients, and another one has work meanwhile.
template <class Function>
void for_each_batch(const SweepInput& input, Ranges ranges, Function&& function) {
  for (const SweepPlan::Range& range : ranges) {
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
  ~VolumeSum() { flush(); }
  VolumeSum(const VolumeSum&) = delete;
  VolumeSum& operator=(const VolumeSum&) = delete;

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
    for (std::size_t i = 0; i < lanes; ++i) {
      const double volume = sixfold[i] / 6;
      volumes_[batch.regions[i].behind.index] += volume;
      volumes_[batch.regions[i].front.index] -= volume;
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

[[gnu::always_inline]] inline void scatter(const Batch& batch, const Shares& shares,
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
}

template <bool with_regions>
SweepSums gradient_pass(const SweepInput& input, Ranges ranges, std::span<double> volumes,
                        std::span<VertexLine> lines) {
  Sums sums(volumes);
  for_each_batch(input, ranges, [&](const auto&... batches) {
    const std::array<Shares, sizeof...(batches)> shares{shares_of<with_regions>(input, batches, sums)...};
    std::size_t i = 0;
    (scatter(batches, shares[i++], lines), ...);
  });
  return sums.whole();
}

template <bool with_regions>
SweepSums energy_pass(const SweepInput& input, Ranges ranges, std::span<double> volumes) {
  Sums sums(volumes);
  const auto add = [&](const Batch& batch) {
    const Lane3 a = gather(input, batch, 0);
    const Lane3 normal = cross(gather(input, batch, 1) - a, gather(input, batch, 2) - a);
    const Lane doubled = square_root(dot(normal, normal));
    sums.energy += batch.tension * doubled;
    sums.area += batch.weight * doubled;
    if constexpr (with_regions) sums.volume.add(batch, dot(normal, relative(a, input.origin)) * batch.weight);
  };
  for_each_batch(input, ranges, [&](const auto&... batches) { (add(batches), ...); });
  return sums.whole();
}

// Calls pass(ranges, volumes) for each part of a plan, and at last for what lies between them.
template <class Pass>
SweepSums share_out(SweepPlan& plan, std::span<double> volumes, const Pass& pass) {
  const std::size_t parts = plan.size();
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < parts; ++i) plan.sums(i) = pass(plan.inside(i), plan.volumes(i));
  plan.sums(parts) = pass(plan.between(), plan.volumes(parts));
  SweepSums whole;
  std::fill(volumes.begin(), volumes.end(), 0.0);
  for (std::size_t i = 0; i <= parts; ++i) {
    whole.energy += plan.sums(i).energy;
    whole.area += plan.sums(i).area;
    for (std::size_t r = 0; r < volumes.size(); ++r) volumes[r] += plan.volumes(i)[r];
  }
  return whole;
}

template <class Pass>
SweepSums sweep(const SweepInput& input, std::span<double> volumes, const Pass& pass) {
  if (input.plan != nullptr && !input.plan->empty()) return share_out(*input.plan, volumes, pass);
  const SweepPlan::Range all{0, static_cast<std::uint32_t>(input.triangles.size())};
  return pass(Ranges(&all, 1), volumes);
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
  return sweep(input, volumes, [&](Ranges ranges, std::span<double> sums) {
    return input.has_regions ? energy_pass<true>(input, ranges, sums)
                             : energy_pass<false>(input, ranges, sums);
  });
}

SweepSums sweep_gradient(const SweepInput& input, std::span<double> volumes, std::span<VertexLine> lines) {
  film::for_each_block(lines.size(), [&](std::size_t first, std::size_t last) {
    std::fill(lines.data() + first, lines.data() + last, VertexLine{});
  });
  return sweep(input, volumes, [&](Ranges ranges, std::span<double> sums) {
    return input.has_regions ? gradient_pass<true>(input, ranges, sums, lines)
                             : gradient_pass<false>(input, ranges, sums, lines);
  });
}

}  // namespace lamella::energy
