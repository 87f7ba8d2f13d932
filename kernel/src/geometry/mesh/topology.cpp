#include "geometry/mesh/topology.h"

#include <bit>
#include <numeric>
#include <tuple>

namespace delos {
namespace {

/// Mixes the bits of a position; equal ones, −0 and 0 too, give the same.
std::uint64_t hash_of(const Eigen::Vector3d& p) {
  std::uint64_t h = 0;
  for (int i = 0; i < 3; ++i) {
    h = (h ^ std::bit_cast<std::uint64_t>(p[i] + 0.0)) * 0x9e3779b97f4a7c15;
    h ^= h >> 32;
  }
  return h;
}

/// For each vertex the first at its position.
std::vector<std::uint32_t> merged_vertices(const TriangleMesh& mesh) {
  constexpr std::uint32_t kFree = ~0u;
  const auto& vertices = mesh.vertices;
  std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 1), kFree);
  std::vector<std::uint32_t> merged(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    std::size_t slot = hash_of(vertices[v]) & (table.size() - 1);
    while (table[slot] != kFree && vertices[table[slot]] != vertices[v]) {
      slot = (slot + 1) & (table.size() - 1);
    }
    if (table[slot] == kFree) table[slot] = v;
    merged[v] = table[slot];
  }
  return merged;
}

/// Sorts things with a small vertex number into one bucket for each vertex.
class Buckets {
 public:
  explicit Buckets(std::size_t vertices) : first(vertices + 1) {}
  void count(std::uint32_t vertex) { ++first[vertex + 1]; }
  void close() {
    std::partial_sum(first.begin(), first.end(), first.begin());
    next_ = first;
  }
  std::uint32_t place(std::uint32_t vertex) { return next_[vertex]++; }

  std::vector<std::uint32_t> first;

 private:
  std::vector<std::uint32_t> next_;
};

std::array<std::uint32_t, 3> sorted(std::array<std::uint32_t, 3> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Mark triangles with the corners of an earlier one.
void skip_duplicates(Topology& topology, std::size_t vertices) {
  Buckets buckets(vertices);
  const auto smallest = [&](std::size_t t) { return sorted(topology.corners[t])[0]; };
  for (std::size_t t = 0; t < topology.corners.size(); ++t) buckets.count(smallest(t));
  buckets.close();
  std::vector<std::uint32_t> order(topology.corners.size());
  for (std::size_t t = 0; t < order.size(); ++t) {
    order[buckets.place(smallest(t))] = static_cast<std::uint32_t>(t);
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto begin = order.begin() + buckets.first[v];
    const auto end = order.begin() + buckets.first[v + 1];
    const auto key = [&](std::uint32_t t) {
      return std::tuple(sorted(topology.corners[t]), t);
    };
    std::sort(begin, end, [&](auto a, auto b) { return key(a) < key(b); });
    for (auto t = begin; t < end; ++t) {
      if (t == begin || topology.skipped[*t]) continue;
      if (sorted(topology.corners[*t]) == sorted(topology.corners[*(t - 1)])) {
        topology.skipped[*t] = true;
        ++topology.duplicates;
      }
    }
  }
}

/// Calls f(low, half edge) for each side of each triangle that counts.
template <class Function>
void for_each_side(const Topology& topology, Function f) {
  for (std::size_t t = 0; t < topology.corners.size(); ++t) {
    if (topology.skipped[t]) continue;
    const auto& corners = topology.corners[t];
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = corners[i], to = corners[(i + 1) % 3];
      f(std::min(from, to),
        HalfEdge{std::max(from, to), static_cast<std::uint32_t>(t), from < to});
    }
  }
}

}  // namespace

Topology topology_of(const TriangleMesh& mesh) {
  Topology topology;
  const std::vector<std::uint32_t> merged = merged_vertices(mesh);
  topology.corners.reserve(mesh.triangles.size());
  topology.skipped.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t p = merged[a], q = merged[b], r = merged[c];
    topology.corners.push_back({p, q, r});
    topology.skipped.push_back(p == q || q == r || r == p);
  }
  skip_duplicates(topology, mesh.vertices.size());

  Buckets buckets(mesh.vertices.size());
  for_each_side(topology,
                [&](std::uint32_t low, const HalfEdge&) { buckets.count(low); });
  buckets.close();
  topology.half_edges.resize(buckets.first.back());
  for_each_side(topology, [&](std::uint32_t low, const HalfEdge& half) {
    topology.half_edges[buckets.place(low)] = half;
  });
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    std::sort(topology.half_edges.begin() + buckets.first[v],
              topology.half_edges.begin() + buckets.first[v + 1],
              [](const HalfEdge& a, const HalfEdge& b) {
                return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
              });
  }
  topology.first = std::move(buckets.first);
  return topology;
}

Closure closure_of(const Topology& topology) {
  Closure closure;
  if (topology.half_edges.empty()) closure.closed = false;
  for_each_edge(topology, [&](std::uint32_t, std::span<const HalfEdge> edge) {
    const auto rising = std::ranges::count_if(edge, &HalfEdge::rising);
    if (edge.size() % 2 != 0) closure.closed = false;
    if (2 * rising != std::ssize(edge)) closure.oriented = false;
  });
  return closure;
}

}  // namespace delos
