#include "values.h"

namespace delos::python {

py::object to_python(const session::Json& json) {
  switch (json.type()) {
    case session::Json::value_t::object: {
      py::dict all;
      for (const auto& [key, value] : json.items())
        all[py::str(key)] = to_python(value);
      return all;
    }
    case session::Json::value_t::array: {
      py::list all(json.size());
      for (std::size_t i = 0; i < json.size(); ++i) all[i] = to_python(json[i]);
      return all;
    }
    case session::Json::value_t::string:
      return py::str(json.get<std::string>());
    case session::Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case session::Json::value_t::number_integer:
      return py::int_(json.get<std::int64_t>());
    case session::Json::value_t::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    case session::Json::value_t::number_float:
      return py::float_(json.get<double>());
    default:
      return py::none();
  }
}

std::string yaml_text(const py::handle& value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  return py::module_::import("json").attr("dumps")(value).cast<std::string>();
}

std::vector<Override> overrides_of(const py::dict& changes) {
  std::vector<Override> all;
  for (const auto& [path, value] : changes)
    all.push_back({path.cast<std::string>(), yaml_text(value)});
  return all;
}

Eigen::Vector3d three(const py::object& numbers, const char* what) {
  const auto values = numbers.cast<std::vector<double>>();
  if (values.size() != 3)
    throw py::value_error(std::string(what) + ": give three numbers, not " +
                          std::to_string(values.size()));
  return {values[0], values[1], values[2]};
}

}  // namespace delos::python
