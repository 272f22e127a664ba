#include "energy/open_rim.h"

#include <algorithm>

namespace lamella::energy {

namespace {

// How often each region's boundary passes along an edge, in the edge's direction; at most a few regions.
struct Passage {
  film::Region region;
  int times = 0;
};

void count(std::vector<Passage>& passages, film::Region region, int times) {
  if (region.outside()) return;
  for (Passage& p : passages) {
    if (p.region == region) {
      p.times += times;
      return;
    }
  }
  passages.push_back({region, times});
}

// The common case, two sides of one film: they cancel if they run against each other with equal labels, or
// along each other with exchanged ones.
bool cancels(const film::Film& film, film::Side a, film::Side b) {
  const bool opposed = film.edge_of(a).reversed() != film.edge_of(b).reversed();
  const film::RegionPair pair = film.regions(b.triangle());
  return film.regions(a.triangle()) == (opposed ? pair : pair.flipped());
}

}  // namespace

std::vector<RimEdge> open_rims(const film::Film& film) {
  std::vector<RimEdge> rims;
  std::vector<Passage> passages;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const film::Edge e(i);
    if (!film.alive(e)) continue;
    const film::Side first = film.first_side(e);
    if (!first.valid()) continue;
    const film::Side second = film.next_around(first);
    if (second != first && film.next_around(second) == first && cancels(film, first, second)) continue;
    passages.clear();
    film.for_each_side(e, [&](film::Side s) {
      const int along = film.edge_of(s).reversed() ? -1 : 1;
      const film::RegionPair pair = film.regions(s.triangle());
      count(passages, pair.behind, along);
      count(passages, pair.front, -along);
    });
    for (const Passage& p : passages) {
      if (p.times != 0)
        rims.push_back({p.region, film.ends(e)[0], film.ends(e)[1], static_cast<double>(p.times)});
    }
  }
  return rims;
}

// With a, b the ends relative to the origin c: the integral of z dx dy minus a third of x.n is that of curl A
// with A = (-yz, xz, 0)/3, whose line integral along a straight edge is (a x b)_z (a_z + b_z)/6. Moving the
// plane back by c adds c_z/2 (a x b)_z; moving the cone's tip back adds c.(a x b)/6.
double rim_volume(const Vec3& from, const Vec3& to, const Vec3& origin, OpenVolume convention) {
  const Vec3 a = from - origin;
  const Vec3 b = to - origin;
  const Vec3 n = cross(a, b);
  if (convention == OpenVolume::cone_from_origin) return dot(origin, n) / 6;
  return n.z * ((a.z + b.z) / 6 + origin.z / 2);
}

// The cone itself has gradient (q_j x q_k)/6 a triangle; the sweep's sixth of the double area vectors differs
// from that by (a x b)/6 at both ends of each rim edge.
RimGradient rim_volume_gradient(const Vec3& from, const Vec3& to, const Vec3& origin, OpenVolume convention) {
  const Vec3 a = from - origin;
  const Vec3 b = to - origin;
  const Vec3 n = cross(a, b);
  const Vec3 common = n / -6;
  if (convention == OpenVolume::cone_from_origin) {
    return {common + cross(b, origin) / 6, common + cross(origin, a) / 6};
  }
  const double factor = (a.z + b.z) / 6 + origin.z / 2;
  const Vec3 lift{0, 0, n.z / 6};
  return {common + lift + factor * Vec3{b.y, -b.x, 0}, common + lift + factor * Vec3{-a.y, a.x, 0}};
}

RimHessian rim_volume_hessian(const Vec3& from, const Vec3& to, const Vec3& origin, OpenVolume convention) {
  RimHessian h;
  if (convention == OpenVolume::cone_from_origin) {
    h.from_to = film::cross_matrix(origin / -6);
    return h;
  }
  const Vec3 a = from - origin;
  const Vec3 b = to - origin;
  const double factor = (a.z + b.z) / 6 + origin.z / 2;
  const Vec3 by_from{b.y, -b.x, 0};  // of n.z
  const Vec3 by_to{-a.y, a.x, 0};
  const Vec3 lift{0, 0, 1.0 / 6};  // of the factor, by either end
  h.from_from = outer(by_from, lift) + outer(lift, by_from);
  h.to_to = outer(by_to, lift) + outer(lift, by_to);
  h.from_to = outer(by_from, lift) + outer(lift, by_to) + film::cross_matrix({0, 0, -factor});
  return h;
}

void add_rim_volumes(std::span<const RimEdge> rims, std::span<const Vec3> positions, const Vec3& origin,
                     OpenVolume convention, std::span<double> volumes) {
  for (const RimEdge& rim : rims) {
    volumes[rim.region.index] +=
        rim.times * rim_volume(positions[rim.from.index], positions[rim.to.index], origin, convention);
  }
}

}  // namespace lamella::energy
