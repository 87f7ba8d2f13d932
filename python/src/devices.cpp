#include "devices.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <array>
#include <deque>
#include <stdexcept>

#include "delos/plugin/registry.h"
#include "scene.h"
#include "values.h"

namespace delos::python {
namespace {

/// What a class's observe() raised, as the kernel tells it.
[[noreturn]] void fail(const py::error_already_set& raised) {
  throw std::runtime_error(raised.what());
}

/// A device whose readings are an object's observe(p), of a point in its own frame:
/// None, or (z, H, R) with m, m×3 and m×m numbers.
class PythonDevice final : public Device {
 public:
  /// @param object called with the lock held
  explicit PythonDevice(py::object object) : object_(std::move(object)) {}
  ~PythonDevice() override {
    const py::gil_scoped_acquire locked;
    object_ = py::object();
  }

  bool observe(const Target& target, Observation& out) const override {
    const py::gil_scoped_acquire locked;
    try {
      const py::object answer = object_.attr("observe")(target.p_ST);
      if (answer.is_none()) return false;
      const auto [z, H, R] =
          answer.cast<std::tuple<Eigen::VectorXd, Eigen::MatrixXd, Eigen::MatrixXd>>();
      const Eigen::Index m = z.size();
      if (m > kMaxRows || H.rows() != m || H.cols() != 3 || R.rows() != m ||
          R.cols() != m)
        throw std::runtime_error(
            "observe() must give z of m numbers, H of m×3 and R of m×m, m at most " +
            std::to_string(kMaxRows));
      out.z = z;
      out.H = H;
      out.R = R;
      return true;
    } catch (const py::error_already_set& raised) {
      fail(raised);
    }
  }

  bool needs_sight() const override {
    const py::gil_scoped_acquire locked;
    return py::getattr(object_, "needs_sight", py::bool_(true)).cast<bool>();
  }

 private:
  py::object object_;
};

/// What a class says of itself, for as long as the program lives: tables are of static
/// storage.
struct PythonPlugin {
  PluginInfo info;
  py::object type;
  std::deque<std::string> texts;
  std::vector<ParamSpec> params;

  const char* kept(std::string text) {
    return texts.emplace_back(std::move(text)).c_str();
  }
};

/// A plugin's functions know nothing but their parameters, so that each has its place.
constexpr std::size_t kMostPlugins = 64;
std::array<PythonPlugin*, kMostPlugins> g_plugins{};

Device* create(const PythonPlugin& plugin, const ParamValues& values) {
  const py::gil_scoped_acquire locked;
  try {
    py::dict arguments;
    for (std::size_t i = 0; i < plugin.params.size(); ++i)
      arguments[plugin.params[i].name] = values[plugin.params[i].name];
    return new PythonDevice(plugin.type(**arguments));
  } catch (const py::error_already_set& raised) {
    fail(raised);
  }
}

using Create = Device* (*)(const ParamValues&);
template <std::size_t... Slots>
constexpr std::array<Create, sizeof...(Slots)> creators(std::index_sequence<Slots...>) {
  return {
      [](const ParamValues& values) { return create(*g_plugins[Slots], values); }...};
}

/// {name: initial} or {name: (initial, unit)}; None: it must be given.
ParamSpec param_of(PythonPlugin& plugin, const std::string& name,
                   const py::handle& declared) {
  py::object initial = py::reinterpret_borrow<py::object>(declared);
  std::string unit = "1";
  if (py::isinstance<py::tuple>(declared)) {
    const auto both = declared.cast<std::pair<py::object, std::string>>();
    initial = both.first;
    unit = both.second;
  }
  const ParamSpec spec =
      number(plugin.kept(name), plugin.kept(unit), "Of a device written in Python");
  return initial.is_none() ? spec : spec.initially(initial.cast<double>());
}

py::object add_device(const std::string& id, const py::object& type,
                      const py::dict& params) {
  // A class that is defined anew, as in a notebook's cell, takes the place of the old.
  const auto slot =
      std::find_if(g_plugins.begin(), g_plugins.end(),
                   [&](const PythonPlugin* p) { return !p || id == p->info.id; });
  if (slot == g_plugins.end())
    throw std::runtime_error("there are " + std::to_string(kMostPlugins) +
                             " devices in Python already");
  auto plugin = std::make_unique<PythonPlugin>();
  plugin->type = type;
  for (const auto& [name, declared] : params)
    plugin->params.push_back(param_of(*plugin, name.cast<std::string>(), declared));
  static constexpr auto kCreators = creators(std::make_index_sequence<kMostPlugins>());
  const auto place = static_cast<std::size_t>(slot - g_plugins.begin());
  plugin->info = {this_abi(),
                  plugin->kept(id),
                  "0.0.0",
                  "A device written in Python",
                  plugin->params.data(),
                  static_cast<std::uint32_t>(plugin->params.size()),
                  kCreators[place],
                  [](Device* device) { delete device; }};
  plugins().add(plugin->info);
  *slot = plugin.release();  // never freed: devices and tables may outlast anything
  return type;
}

}  // namespace

void bind_devices(py::module_& module) {
  module.def(
      "add_device", add_device, py::arg("id"), py::arg("type"),
      py::arg("params") = py::dict(),
      "Let scenes name a class of Python as `type: id`. Slow: for a first try.\n\n"
      "type: called with the parameters of a scene as keywords, SI; its observe(p) is "
      "asked for a point p, metres in the device's frame, from many threads, and gives "
      "None where it sees nothing, or (z, H, R): m readings, their m×3 Jacobian, their "
      "m×m covariance. needs_sight = False: nothing hides the point.\n"
      "params: {name: initial value} or {name: (initial value, SI unit)}; None: it "
      "must be given.\n"
      "Of one id the last counts. Raises ValueError where a plugin has it.");
}

}  // namespace delos::python
