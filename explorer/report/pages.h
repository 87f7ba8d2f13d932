// The pages that delos report writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delos/field/blind.h"
#include "delos/field/evaluate.h"
#include "delos/optimize/answers.h"
#include "delos/optimize/study.h"
#include "report/pictures.h"

namespace delos::report {

/// A plugin that a scene uses.
struct PluginVersion {
  std::string type, version;
};

/// What one device is to a field.
struct DeviceRow {
  std::string name, type;
  Eigen::Vector3d at;
  bool on_target = false;
  double seen = 0;  ///< part of the samples outside solids that it sees
  /// Where it is taken away: how many samples aren't observable any more, and by how
  /// much the metric's mean over those that remain is larger, relative.
  std::size_t lost = 0;
  double mean_rise = 0;
};

/// A scene as it stands.
struct SceneReport {
  std::string file;  ///< as the user named it
  Scene scene;
  Field field;
  bool larger_is_better = false;
  std::vector<View> views;
  std::vector<Marker> markers;
  std::vector<DeviceRow> devices;
  std::vector<BlindRegion> blind;
  Html installation;  ///< as installers_sheet()
  std::vector<PluginVersion> plugins;
  std::string version;  ///< of this program
};
[[nodiscard]] std::string scene_page(const SceneReport& report);

/// A variable before and after.
struct VariableRow {
  std::string path, unit;  ///< SI
  double before = 0, after = 0;
  double lower = 0, upper = 0;
  bool locked = false;
};

/// What stands between a design and its constraints.
struct ConstraintRow {
  ConstraintReport report;
  std::string words, unit;
};

/// A search, as far as it is.
struct StudyReport {
  std::string file;
  StudySummary summary;
  Scene before, after;
  std::string objective, objective_unit;  ///< "mean eigmax", SI
  double objective_before = 0, objective_after = 0;
  bool larger_is_better = false;
  Field field_before, field_after;  ///< on the same samples
  std::vector<View> views_before, views_after;
  std::vector<Marker> were, are;
  std::vector<std::vector<StudyEvaluation>> evaluations;  ///< one list a round
  bool maximize = false;  ///< objectives of evaluations are negative then
  std::vector<ConstraintRow> constraints;
  std::vector<VariableRow> variables;
  std::optional<Answers> answers;
  std::vector<PluginVersion> plugins;
  std::string version;
  Html more;  ///< sections that stand before the acts
};
[[nodiscard]] std::string study_page(const StudyReport& report);

/// A table of versions, for both pages.
[[nodiscard]] Html versions(const std::string& program, const std::string& begun_with,
                            const std::vector<PluginVersion>& plugins);

}  // namespace delos::report
