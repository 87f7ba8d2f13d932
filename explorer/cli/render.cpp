// delos render: the field in its room, without a display.
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "json.h"
#include "output/write.h"
#include "render/picture.h"
#include "through.h"

namespace delos::cli {
namespace {

constexpr int kLeastPixels = 200, kMostPixels = 8192;

struct RenderCommand {
  SceneOptions options;
  std::filesystem::path scene, out;
  std::string view = "corner", layers;
  std::vector<std::string> slices, surfaces, between;
  std::string relief;
  bool orthographic = false;
  ThroughOptions through;
  render::PictureOptions picture;
};

struct Layer {
  const char* name;
  bool render::PictureOptions::*shown;
};
constexpr Layer kLayers[8] = {{"devices", &render::PictureOptions::devices},
                              {"frusta", &render::PictureOptions::frusta},
                              {"names", &render::PictureOptions::names},
                              {"bodies", &render::PictureOptions::bodies},
                              {"beacons", &render::PictureOptions::beacons},
                              {"floor", &render::PictureOptions::floor},
                              {"box", &render::PictureOptions::box},
                              {"cells", &render::PictureOptions::cells}};

void choose_layers(const std::string& text, render::PictureOptions& picture) {
  for (const Layer& layer : kLayers) picture.*layer.shown = false;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    if (word == "none") continue;
    const auto* layer = std::ranges::find(kLayers, word, &Layer::name);
    if (layer == std::end(kLayers)) {
      std::string names;
      for (const Layer& known : kLayers) names += std::string(", ") + known.name;
      throw Failure{kUsage, "--layers: there is no '" + word + "': some of none" +
                                names + ", with commas between"};
    }
    picture.*layer->shown = true;
  }
}

double quantity_of(const std::string& text, const std::string& unit,
                   const std::string& option) {
  const auto read = parse_quantity(text, unit);
  if (const auto* problem = std::get_if<std::string>(&read))
    throw Failure{kUsage, option + ": " + *problem};
  return std::get<double>(read);
}

/// "z", or "z=1.5 m".
render::Slice slice_of(const std::string& text) {
  const std::string axis = text.substr(0, text.find('='));
  if (axis != "x" && axis != "y" && axis != "z")
    throw Failure{kUsage, "--slice '" + text +
                              "': should be x, y or z, or such as "
                              "'z=1.5 m'"};
  render::Slice slice{axis[0] - 'x'};
  if (axis != text)
    slice.at = quantity_of(text.substr(axis.size() + 1), "m", "--slice '" + text + "'");
  return slice;
}

/// "17 mm,25 mm"; an end may be left out.
std::pair<double, double> ends_of(const std::string& text, const std::string& unit) {
  const std::string option = "--between '" + text + "'";
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw Failure{kUsage, option +
                              ": should be two values with a comma between, such "
                              "as '17 mm,25 mm'; one may be left out"};
  const auto end = [&](const std::string& part, double open) {
    return part.empty() ? open : quantity_of(part, unit, option);
  };
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  const std::pair<double, double> ends{end(text.substr(0, comma), -kOpen),
                                       end(text.substr(comma + 1), kOpen)};
  if (!(ends.first <= ends.second))
    throw Failure{kUsage, option + ": the first is greater than the second"};
  return ends;
}

render::PictureOptions picture_of(const RenderCommand& command,
                                  const LoadedScene& loaded) {
  render::PictureOptions picture = command.picture;
  picture.view = read_option([&] { return render::view_of(command.view); });
  picture.view.orthographic = command.orthographic;
  if (!command.layers.empty()) choose_layers(command.layers, picture);
  for (const std::string& slice : command.slices)
    if (slice != "none") picture.slices.push_back(slice_of(slice));
  for (const std::string& level : command.surfaces)
    picture.levels.push_back(
        quantity_of(level, loaded.metric.unit, "--surface '" + level + "'"));
  for (const std::string& ends : command.between)
    picture.between.push_back(ends_of(ends, loaded.metric.unit));
  if (!command.relief.empty()) {
    picture.reliefs = true;
    picture.relief_height =
        quantity_of(command.relief, "m", "--relief '" + command.relief + "'");
  }
  if (command.slices.empty() && command.surfaces.empty() && command.between.empty() &&
      !picture.cloud)
    picture.slices.push_back({});
  if (!command.through.method.empty()) {
    picture.through = through_of(command.through, "through");
    picture.through->relief = picture.reliefs ? picture.relief_height : 0;
  }
  return picture;
}

Json answer(const render::Picture& picture, const RenderCommand& command,
            const LoadedScene& loaded) {
  Json json{{"file", command.out.string()},
            {"width", picture.width},
            {"height", picture.height},
            {"metric", {{"name", loaded.metric.name}, {"unit", loaded.metric.unit}}},
            {"range", nullptr},
            {"surfaces", Json::array()},
            {"bodies", Json::array()},
            {"through", picture.through}};
  if (picture.range)
    json["range"] = {{"min", picture.range->first}, {"max", picture.range->second}};
  for (const render::DrawnShape& shape : picture.shapes)
    if (shape.low == shape.high)
      json["surfaces"].push_back({{"level", shape.low}, {"area", shape.area}});
    else
      json["bodies"].push_back({{"low", session::number(shape.low)},
                                {"high", session::number(shape.high)},
                                {"area", shape.area},
                                {"volume", shape.volume}});
  return json;
}

std::string words_of(const render::DrawnShape& shape, const std::string& unit) {
  const auto value = [&](double v) { return format_quantity(v, unit); };
  if (shape.low == shape.high)
    return "surface at " + value(shape.low) + ": " + format_quantity(shape.area, "m^2");
  const bool from = std::isfinite(shape.low), to = std::isfinite(shape.high);
  return "body" + (from ? " from " + value(shape.low) : "") +
         (to ? " to " + value(shape.high) : "") + ": " +
         format_quantity(shape.volume, "m^3");
}

int run(const RenderCommand& command) {
  if (command.out.extension() != ".png")
    throw Failure{kUsage, "-o '" + command.out.string() + "': should end in .png"};
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  const render::PictureOptions picture = picture_of(command, loaded);
  const Interrupt interrupt;
  Progress progress(loaded.scene.name);
  const session::DrawnField drawn = [&] {
    try {
      return session::draw_field(loaded, 0,
                                 field_options(command.options, interrupt, progress));
    } catch (const std::invalid_argument& error) {
      throw unsolvable(command.options, error);
    }
  }();
  const render::Picture drawn_picture =
      read_option([&] { return render::render_picture(loaded, drawn, picture); });
  if (const std::string problem = write_text(command.out, png_of(drawn_picture));
      !problem.empty())
    throw Failure{kDiagnostics, problem};
  if (command.options.json) {
    print_document(answer(drawn_picture, command, loaded));
  } else {
    for (const render::DrawnShape& shape : drawn_picture.shapes)
      std::cout << words_of(shape, loaded.metric.unit) << "\n";
    if (!drawn_picture.through.is_null())
      std::cout << through_words(drawn_picture.through, loaded.metric.unit) << "\n";
    std::cout << "wrote " << command.out.string() << "\n";
  }
  return drawn.field.cancelled ? kCancelled : kDone;
}

}  // namespace

void add_render_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<RenderCommand>();
  CLI::App* app = program.add_subcommand(
      "render", "The field in its room as a picture, without a display");
  app->add_option("scene", command->scene, "Scene file")->required();
  app->add_option("-o,--out", command->out, "The picture, .png")->required();
  app->add_option(
         "--view", command->view,
         "corner, top, below, front, back, right or left, or "
         "azimuth,elevation[,distance] of the eye: 30,25 or '30 deg,25 deg,8 m'")
      ->capture_default_str();
  app->add_flag("--orthographic", command->orthographic, "Without perspective");
  app->add_option("--slice", command->slices,
                  "A layer of the samples: x, y, z (the middle) or 'z=1.5 m', or none; "
                  "repeatable; by default z")
      ->allow_extra_args(false);
  app->add_option("--surface", command->surfaces,
                  "A surface on which the metric has one value: '1 mm'; repeatable")
      ->allow_extra_args(false);
  app->add_option("--between", command->between,
                  "The body on which the metric lies between two values: '17 mm,25 "
                  "mm', '17 mm,' or ',25 mm'; repeatable")
      ->allow_extra_args(false);
  app->add_flag("--cloud", command->picture.cloud,
                "The volume as a cloud, densest where it is good");
  app->add_option(
      "--relief", command->relief,
      "Slices, planes and a surface through samples as high as their values; the "
      "end of the colour bar is as high as this: '1 m', or as low: '-1 m', "
      "so that small values are peaks");
  add_through_options(*app, "through", command->through);
  app->add_option(
      "--layers", command->layers,
      "Only these of devices, frusta, names, bodies, beacons, floor, box, and cells of "
      "an octree: those that slices cut, or all; or none");
  app->add_option("--width", command->picture.width, "Pixels")
      ->check(CLI::Range(kLeastPixels, kMostPixels))
      ->capture_default_str();
  app->add_option("--height", command->picture.height, "Pixels")
      ->check(CLI::Range(kLeastPixels, kMostPixels))
      ->capture_default_str();
  app->add_flag("--log10", command->picture.log10, "Colours follow log10");
  app->add_flag("--dark", command->picture.dark, "On a dark ground");
  add_scene_options(*app, command->options);
  app->footer(
      "Bright is good, blind is hatched. What hides is opaque; a room's walls are "
      "lines.\n"
      "Examples:\n"
      "  delos render scenes/05-optitrack-lab.yaml -o lab.png\n"
      "  delos render scenes/06-furnished-lab.yaml --view top --orthographic --slice "
      "'z=1.2 m' -o plan.png\n"
      "  delos render scenes/01-acoustic.yaml --view 60,15 --surface '25 mm' --surface "
      "'40 mm' --log10 -o surfaces.png\n"
      "  delos render scenes/04-motion-capture.yaml --slice 'z=5.6 ft' --relief '1.5 "
      "m' -o "
      "relief.png\n"
      "  delos render scenes/17-crowded-room.yaml --through natural-neighbour --relief "
      "'50 cm' -o path.png\n"
      "  delos render scenes/07-torso.yaml --metric coverage --layers devices,names -o "
      "torso.png");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
