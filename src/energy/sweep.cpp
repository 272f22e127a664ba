#include "energy/sweep.h"

#include <algorithm>
#include <cmath>

#include "energy/lanes.h"
#include "film/blocks.h"

namespace lamella::energy {

namespace {

// Four triangles side by side. The last batch of a film may hold fewer: its spare lanes repeat a triangle
// with weight 0.
struct Batch {
  std::array<std::array<film::Vertex, 3>, lanes> corners;
  std::array<film::RegionPair, lanes> regions;
  Lane tension;
  Lane weight;
  bool full = true;
};

Batch full_batch(const SweepInput& input, std::size_t first) {
  Batch batch;
  std::copy_n(input.triangles.data() + first, lanes, batch.corners.data());
  if (input.has_regions) std::copy_n(input.regions.data() + first, lanes, batch.regions.data());
  batch.weight = Lane{1, 1, 1, 1};
  batch.tension = batch.weight;
  if (!input.tension.empty()) std::memcpy(&batch.tension, input.tension.data() + first, sizeof batch.tension);
  return batch;
}

Batch last_batch(const SweepInput& input, std::size_t first) {
  Batch batch;
  batch.full = false;
  for (std::size_t i = 0; i < lanes; ++i) {
    const bool spare = first + i >= input.triangles.size();
    const std::size_t t = spare ? first : first + i;
    batch.corners[i] = input.triangles[t];
    batch.regions[i] = input.regions[t];
    batch.weight[i] = spare ? 0.0 : 1.0;
    batch.tension[i] = spare ? 0.0 : input.tension.empty() ? 1.0 : input.tension[t];
  }
  return batch;
}

using Ranges = std::span<const SweepPlan::Range>;

template <class Function>
void for_each_batch(const SweepInput& input, Ranges ranges, Function&& function) {
  for (const SweepPlan::Range& range : ranges) {
    std::size_t first = range.first;
    for (; first + lanes <= range.last; first += lanes) function(full_batch(input, first));
    if (first < range.last) function(last_batch(input, first));
  }
}

Lane3 gather(const SweepInput& input, const Batch& batch, std::size_t corner) {
  std::array<Lane, lanes> p;
  for (std::size_t i = 0; i < lanes; ++i) p[i] = load(input.positions, batch.corners[i][corner].index);
  const std::array<Lane, 4> axes = transposed(p[0], p[1], p[2], p[3]);
  return {axes[0], axes[1], axes[2]};
}

// +1 where the normal points into the region of lower number, -1 into the higher, 0 where both are the same.
Lane orientations(const Batch& batch) {
  Lane s;
  for (std::size_t i = 0; i < lanes; ++i) {
    const film::RegionPair pair = batch.regions[i];
    s[i] = static_cast<double>(static_cast<int>(pair.front < pair.behind) -
                               static_cast<int>(pair.behind < pair.front));
  }
  return s;
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
    const auto& pair = batch.regions;
    const bool alike = pair[0] == pair[1] && pair[0] == pair[2] && pair[0] == pair[3];
    if (alike && batch.full) {
      if (!(pair[0] == run_)) {
        flush();
        run_ = pair[0];
      }
      sum_ += sixfold;
      return;
    }
    for (std::size_t i = 0; i < lanes; ++i) {
      const double volume = sixfold[i] * batch.weight[i] / 6;
      volumes_[pair[i].behind.index] += volume;
      volumes_[pair[i].front.index] -= volume;
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

// Adds to one corner of each triangle: first the four values of its own, then the four all corners share.
void scatter(const Batch& batch, std::size_t corner, const std::array<Lane, 4>& own,
             const std::array<Lane, 4>& common, std::span<VertexLine> lines) {
  for (std::size_t i = 0; i < lanes; ++i) {
    VertexLine& line = lines[batch.corners[i][corner].index];
    add_to(&line.gradient.x, own[i]);
    add_to(&line.area_vector.x, common[i]);
  }
}

template <bool with_regions>
SweepSums gradient_pass(const SweepInput& input, Ranges ranges, std::span<double> volumes,
                        std::span<VertexLine> lines) {
  Lane energy{};
  Lane area_sum{};
  VolumeSum volume(volumes);
  for_each_batch(input, ranges, [&](const Batch& batch) {
    const Lane3 a = gather(input, batch, 0);
    const Lane3 b = gather(input, batch, 1);
    const Lane3 c = gather(input, batch, 2);
    const Lane3 ab = b - a;
    const Lane3 bc = c - b;
    const Lane3 ca = a - c;
    const Lane3 normal = cross(ca, ab);  // twice the vector area
    const Lane doubled = square_root(dot(normal, normal));
    const Lane inverse = 1.0 / (doubled > 0 ? doubled : Lane{1, 1, 1, 1});  // no area, no gradient
    const Lane area = 0.5 * doubled * batch.weight;
    energy += batch.tension * 0.5 * doubled;
    area_sum += area;

    const Lane ratio = (dot(ab, ab) + dot(bc, bc) + dot(ca, ca)) * (0.5 * inverse);
    const Lane under = ratio * ratio - 3.0;
    const Lane stiffness = 0.5 * batch.tension * (ratio + square_root(under > 0 ? under : Lane{}));
    Lane3 vector{};
    if constexpr (with_regions) {
      vector = normal * (orientations(batch) * batch.weight / 6.0);
      volume.add(batch, dot(normal, relative(a, input.origin)));
    }
    const std::array<Lane, 4> common = transposed(vector.x, vector.y, vector.z, area / 3.0);
    const Lane3 pull = normal * (0.5 * batch.tension * inverse);
    const Lane3 at_a = cross(pull, bc);
    const Lane3 at_b = cross(pull, ca);
    const Lane3 at_c = cross(pull, ab);
    scatter(batch, 0, transposed(at_a.x, at_a.y, at_a.z, stiffness), common, lines);
    scatter(batch, 1, transposed(at_b.x, at_b.y, at_b.z, stiffness), common, lines);
    scatter(batch, 2, transposed(at_c.x, at_c.y, at_c.z, stiffness), common, lines);
  });
  return {sum(energy), sum(area_sum)};
}

template <bool with_regions>
SweepSums energy_pass(const SweepInput& input, Ranges ranges, std::span<double> volumes) {
  Lane energy{};
  Lane area_sum{};
  VolumeSum volume(volumes);
  for_each_batch(input, ranges, [&](const Batch& batch) {
    const Lane3 a = gather(input, batch, 0);
    const Lane3 normal = cross(gather(input, batch, 1) - a, gather(input, batch, 2) - a);
    const Lane area = 0.5 * square_root(dot(normal, normal));
    energy += area * batch.tension;
    area_sum += area * batch.weight;
    if constexpr (with_regions) volume.add(batch, dot(normal, relative(a, input.origin)));
  });
  return {sum(energy), sum(area_sum)};
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
