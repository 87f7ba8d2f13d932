#include "session/faces.h"

#include <limits>

#include "delos/geometry/surface.h"
#include "delos/scene/clutter.h"
#include "session/description.h"

namespace delos::session {
namespace {

TriangleMesh patch_mesh(const PatchSurface& s) {
  return {{s.origin, s.origin + s.u, s.origin + s.u + s.v, s.origin + s.v},
          {{0, 1, 2}, {0, 2, 3}}};
}

/// Where a ray meets a triangle whose corners run counterclockwise, as a multiple of
/// `along`; infinity where it doesn't. Möller and Trumbore (1997), with culling.
double meeting(const Eigen::Vector3d& from, const Eigen::Vector3d& along,
               const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               const Eigen::Vector3d& c) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d u = b - a, v = c - a, q = along.cross(v);
  const double det = u.dot(q);
  if (!(det > 0)) return kNever;
  const Eigen::Vector3d s = from - a, r = s.cross(u);
  const double bu = s.dot(q), bv = along.dot(r), t = v.dot(r);
  if (bu < 0 || bv < 0 || bu + bv > det || t < 0) return kNever;
  return t / det;
}

}  // namespace

Faces::Faces(const LoadedScene& loaded, const std::string& but) {
  for (const OccluderEntry& entry : all_occluders(loaded.scene))
    if (entry.mount == Mount::world)
      add(transformed(body_mesh(entry.body), pose_of(entry.placement)), entry.room);
  for (const SurfaceEntry& surface : loaded.scene.surfaces) {
    if (const auto* patch = std::get_if<PatchSurface>(&surface.shape))
      add(patch_mesh(*patch), false);
    if (const auto* mesh = std::get_if<MeshSurface>(&surface.shape))
      add(body_mesh(mesh->mesh), false);
  }
  Eigen::AlignedBox3d room = sample_box(loaded.scene);
  for (const PlacedDevice& device : loaded.system.devices)
    if (!device.carried() && device.name != but) room.extend(device.X_WS().p);
  if (room.sizes().minCoeff() > 0)
    add(body_mesh(BoxShape{room.min(), room.max()}), true);
}

void Faces::add(const TriangleMesh& mesh, bool inside_free) {
  const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
  mesh_.vertices.insert(mesh_.vertices.end(), mesh.vertices.begin(),
                        mesh.vertices.end());
  for (std::array<std::uint32_t, 3> t : mesh.triangles) {
    if (inside_free) std::swap(t[1], t[2]);
    mesh_.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

std::optional<Contact> Faces::nearest(const Eigen::Vector3d& p, double within) const {
  if (mesh_.triangles.empty()) return std::nullopt;
  const SurfacePoint point = MountingSurface(mesh_).closest(p);
  if ((point.p - p).norm() > within) return std::nullopt;
  return Contact{point.p, point.normal};
}

std::optional<Contact> Faces::first(const Eigen::Vector3d& from,
                                    const Eigen::Vector3d& along) const {
  double least = std::numeric_limits<double>::infinity();
  std::optional<Contact> contact;
  for (const auto& t : mesh_.triangles) {
    const Eigen::Vector3d &a = mesh_.vertices[t[0]], &b = mesh_.vertices[t[1]],
                          &c = mesh_.vertices[t[2]];
    const double at = meeting(from, along, a, b, c);
    if (!(at < least)) continue;
    least = at;
    contact = {from + at * along, (b - a).cross(c - a).normalized()};
    // In the plane of the face, whatever the ray's length has rounded away.
    contact->p -= (contact->p - a).dot(contact->normal) * contact->normal;
  }
  return contact;
}

Eigen::Matrix3d turned_to(const Eigen::Matrix3d& R, const Eigen::Vector3d& z) {
  return Eigen::Quaterniond::FromTwoVectors(R.col(2), z).toRotationMatrix() * R;
}

}  // namespace delos::session
