// What a part of a scene may begin as, before a hand has changed it.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "delos/document/shape.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// First values, of about the size of a room and in its middle.
class Starts {
 public:
  explicit Starts(const LoadedScene& loaded);

  /// A value of a shape, as text. @param key that it stands under
  [[nodiscard]] Json value(const Shape& shape, const std::string& key) const;

  /// A new member of a section's list or table, and what it is called: "box".
  struct Member {
    std::string label;
    Json value;
  };
  /// @param place path of the list: "occluders", "objective.terms"
  [[nodiscard]] std::vector<Member> members(const Shape& item,
                                            const std::string& place) const;

 private:
  [[nodiscard]] Json known(const std::string& key) const;
  [[nodiscard]] Json required(const std::vector<KeyShape>& keys) const;
  /// Mappings whose keys are no part of their shape's required ones.
  [[nodiscard]] Json special(const std::string& place, const std::string& form) const;

  const LoadedScene& loaded_;
  Eigen::AlignedBox3d room_;
};

}  // namespace delos::session
