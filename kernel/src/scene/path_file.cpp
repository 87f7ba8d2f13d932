#include "delos/scene/path_file.h"

#include "document/file_text.h"
#include "document/findings.h"
#include "scene/point_file.h"

namespace delos {

std::optional<std::vector<PathRow>> load_path(const std::filesystem::path& file,
                                              Diagnostics& diagnostics) {
  Findings findings;
  const int source = findings.add_source(file.string());
  const auto refuse = [&](const std::string& problem) {
    findings.error({source, 0, 0}, {}, problem);
  };
  std::vector<PathRow> path;
  std::string why;
  if (!is_point_file(file.string())) {
    refuse("a path is a .csv or .ptl file of rows t,x,y,z");
  } else if (const auto text = file_text(file, why); !text) {
    refuse("the path can't be read: " + why);
  } else {
    const RowForm form{{"t", "x", "y", "z"}, {4}};
    for (const auto& row : parse_rows(*text, file.string(), form, source, findings))
      path.push_back({row[0], {row[1], row[2], row[3]}});
    if (findings.errors() == 0 && path.size() < 2)
      refuse("a path needs two rows t,x,y,z at least");
    for (std::size_t i = 1; i < path.size() && findings.errors() == 0; ++i)
      if (!(path[i].t > path[i - 1].t))
        refuse("times must rise: row " + std::to_string(i + 1) +
               " isn't later than the row before it; sort the rows by t");
  }
  const bool sound = findings.errors() == 0;
  findings.move_to(diagnostics);
  if (!sound) return std::nullopt;
  return path;
}

}  // namespace delos
