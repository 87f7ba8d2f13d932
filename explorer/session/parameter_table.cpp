#include "session/parameter_table.h"

namespace delos::session {

const char* word(ParamKind kind) {
  switch (kind) {
    case ParamKind::number:
      return "number";
    case ParamKind::choice:
      return "choice";
    case ParamKind::vector:
      return "vector";
    case ParamKind::matrix:
      return "matrix";
    case ParamKind::text:
      return "text";
  }
  return "";
}

Json parameter_table(const PluginInfo& info) {
  Json json{{"id", info.id}, {"version", info.version}, {"summary", info.summary}};
  json["params"] = Json::array();
  for (std::uint32_t i = 0; i < info.n_params; ++i) {
    const ParamSpec& p = info.params[i];
    Json row{{"name", p.name}, {"kind", word(p.kind)}, {"unit", p.unit}};
    if (p.kind == ParamKind::number) {
      row["default"] = number(p.initial);
      row["scale"] = p.scale == ParamScale::log ? "log" : "linear";
    } else {
      row["default"] = p.text ? Json(p.text) : Json();
    }
    if (p.kind == ParamKind::choice) row["choices"] = p.choices;
    row["lower"] = number(p.lower);
    row["upper"] = number(p.upper);
    row["help"] = p.help;
    json["params"].push_back(row);
  }
  return json;
}

}  // namespace delos::session
