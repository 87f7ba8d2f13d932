// The fields that a page draws, kept for the shapes that it wants of them.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "session/drawn_field.h"

namespace delos::server {

struct KeptField {
  std::size_t revision = 0;  ///< of the design
  std::shared_ptr<const session::DrawnField> drawn;
};

/// The last field of each kind. From all threads: shapes are made beside what is worked
/// out of the design.
class KeptFields {
 public:
  /// Values, mask and parts are kept; of an octree, its nodes.
  void keep(const std::string& kind, std::size_t revision, session::DrawnField drawn) {
    Field slim;
    slim.value = std::move(drawn.field.value);
    slim.samples.parts = std::move(drawn.field.samples.parts);
    drawn.field = std::move(slim);
    drawn.summary = {};
    KeptField kept{revision,
                   std::make_shared<const session::DrawnField>(std::move(drawn))};
    const std::lock_guard lock(mutex_);
    fields_[kind] = std::move(kept);
  }
  /// Without a field where none was drawn.
  [[nodiscard]] KeptField find(const std::string& kind) const {
    const std::lock_guard lock(mutex_);
    const auto found = fields_.find(kind);
    return found == fields_.end() ? KeptField{} : found->second;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, KeptField> fields_;
};

}  // namespace delos::server
