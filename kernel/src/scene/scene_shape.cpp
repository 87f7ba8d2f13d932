#include "delos/scene/scene_shape.h"

#include "scene/scene_keys.h"

namespace delos {
namespace {

using namespace shapes;

/// Those that resolve_extends() takes, and any of the others.
std::vector<KeyShape> extending_keys() {
  std::vector<KeyShape> keys = {
      {"extends", true, "the scene that this one is, but for what stands here", text()},
      {"set", false, "single values by their paths, changed then",
       table([] { return anything(); })}};
  for (KeyShape key : scene_keys()) {
    key.required = false;
    keys.push_back(key);
  }
  return keys;
}

}  // namespace

Shape scene_shape() {
  return either([] { return std::vector{map(scene_keys), map(extending_keys)}; });
}

}  // namespace delos
