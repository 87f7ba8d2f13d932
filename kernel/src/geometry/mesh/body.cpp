#include "delos/geometry/body.h"

#include "delos/geometry/primitives.h"

namespace delos {
namespace {

struct Make {
  TriangleMesh operator()(const BoxShape& b) const { return make_box(b.min, b.max); }
  TriangleMesh operator()(const CylinderShape& c) const {
    return make_cylinder(c.radius, c.height, c.sides);
  }
  TriangleMesh operator()(const SphereShape& s) const { return make_sphere(s.radius); }
  TriangleMesh operator()(const PrismShape& p) const {
    return extrude(p.polygon, p.height);
  }
  TriangleMesh operator()(const MeshShape& m) const {
    return transformed(*m.mesh, {}, m.scale);
  }
};

}  // namespace

TriangleMesh body_mesh(const Body& body) { return std::visit(Make{}, body); }

}  // namespace delos
