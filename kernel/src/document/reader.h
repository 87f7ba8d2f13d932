// Reads values out of a tree of texts and says what is wrong with them, by path.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "delos/document/shape.h"
#include "delos/plugin/registry.h"
#include "delos/text/words.h"
#include "document/findings.h"
#include "document/yaml_tree.h"
#include "geometry/mesh/mesh_files.h"

namespace delos {

/// A node and the way to it from the root. Lives on the stack while the node is read.
class Place {
 public:
  explicit Place(const Node& root) : node_(root) {}
  /// @param shape what the value should look like; null where the reader says it
  Place(const Place& parent, std::string segment, const Node& node,
        const Shape* shape = nullptr)
      : parent_(&parent), segment_(std::move(segment)), node_(node), shape_(shape) {}

  [[nodiscard]] const Node& node() const { return node_; }
  [[nodiscard]] const Shape* shape() const { return shape_; }
  /// "devices.s1.at.x"; empty for the root.
  [[nodiscard]] std::string path() const;
  /// The path of something in this node: path() + "." + segment.
  [[nodiscard]] std::string path(std::string_view segment) const;

 private:
  const Place* parent_ = nullptr;
  std::string segment_;
  const Node& node_;
  const Shape* shape_ = nullptr;
};

/// How paths call the components of a list of coordinates.
inline constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
/// And those of angles.
inline constexpr std::array<const char*, 3> kAngles = {"roll", "pitch", "yaw"};

/// Reads single values. A function that returns nullopt or false has made a finding.
struct Reader {
  Findings& findings;
  PluginRegistry& plugins;
  std::filesystem::path folder;  ///< what relative paths start from
  MeshFiles meshes{};
  /// Where the texts that the scene extends look for files, from the folder above.
  std::map<int, std::filesystem::path> folder_of_source{};

  /// The name of a file that is written at a place, as it is from `folder`.
  [[nodiscard]] std::string file_name(const Place& at,
                                      const std::string& written) const;

  /// "path: problem" at the place's node.
  void error(const Place& at, std::string problem);
  void warning(const Place& at, std::string problem);
  /// About something that should be in the place, or that is there under a key.
  void error_within(const Place& at, Mark mark, std::string_view segment,
                    std::string problem);

  /// A finding where the node is of another kind.
  bool expect(const Place& at, Node::Kind kind, std::string_view what);

  std::optional<double> number(const Place& at, std::string_view unit);
  /// A number of the place's shape, whose bounds are kept to.
  std::optional<double> number(const Place& at);
  /// The same of an angle. Radians without a unit of more than a full turn are what
  /// degrees look like: a warning.
  std::optional<double> angle(const Place& at);
  /// Whether bounds hold a number; a finding where they don't.
  bool within(const Place& at, double value, const Bounds& bounds,
              std::string_view unit);
  std::optional<int> integer(const Place& at, int least, int greatest);
  /// A whole number of the place's shape.
  std::optional<int> integer(const Place& at);
  std::optional<std::string> word(const Place& at);
  /// A word that isn't part of a path's syntax: names of devices, groups, samples.
  std::optional<std::string> name(const Place& at);
  /// Key i of a mapping, as such a name.
  std::string key_name(const Place& map, std::size_t i);
  /// [x, y, z]
  std::optional<Eigen::Vector3d> vector3(
      const Place& at, std::string_view unit,
      const std::array<const char*, 3>& components = kAxes);
  /// [[x, y, z], …], not empty
  std::optional<std::vector<Eigen::Vector3d>> vectors3(
      const Place& at, std::string_view unit,
      const std::array<const char*, 3>& components = kAxes);
  /// A list of rows of one length; `unit` of entry (i, j).
  std::optional<Eigen::MatrixXd> matrix(
      const Place& at, const std::function<std::string(int, int)>& unit);

  /// One of a few words.
  template <class Enum, std::size_t N>
  std::optional<Enum> choice(const Place& at,
                             const std::pair<const char*, Enum> (&words)[N]) {
    std::array<std::string, N> known;
    for (std::size_t i = 0; i < N; ++i) known[i] = words[i].first;
    const auto index = choice(at, std::span<const std::string>(known));
    if (!index) return std::nullopt;
    return words[*index].second;
  }
  std::optional<std::size_t> choice(const Place& at,
                                    std::span<const std::string> known);
};

/// vector3() of metres into `out`, which stays as it is where that has a finding.
void read_vector(Reader& reader, const Place& at, Eigen::Vector3d& out);

/// "; did you mean 'focal'?", or "; known: a, b, c" where nothing is near.
[[nodiscard]] std::string suggestion(std::string_view word,
                                     std::span<const std::string> known);

/// Report every key that a map holds twice, in the whole tree.
void check_duplicate_keys(Reader& reader, const Place& at);

}  // namespace delos
