// Models of COLMAP as text: cameras.txt and images.txt in one folder. Each image is a
// camera in its place, p_C = R(q) p_W + t with q = QW QX QY QZ. The middle of the first
// pixel is at (0.5, 0.5): c is half a pixel less here. Scale and up are free.
#include <Eigen/Geometry>
#include <fstream>
#include <map>
#include <sstream>

#include "imports/formats.h"

namespace delos::imports {
namespace {

struct ColmapModel {
  const char* name;
  std::size_t parameters;
  bool one_focal, fisheye;
};
/// In COLMAP's order of parameters: f or f_x f_y, c_x c_y, coefficients.
constexpr ColmapModel kModels[] = {
    {"SIMPLE_PINHOLE", 3, true, false}, {"PINHOLE", 4, false, false},
    {"SIMPLE_RADIAL", 4, true, false},  {"RADIAL", 5, true, false},
    {"OPENCV", 8, false, false},        {"FULL_OPENCV", 12, false, false},
    {"OPENCV_FISHEYE", 8, false, true}, {"SIMPLE_RADIAL_FISHEYE", 4, true, true},
    {"RADIAL_FISHEYE", 5, true, true},
};

/// A line's words; those of numbers by number_at().
std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word && words.size() < 64;) words.push_back(word);
  return words;
}

std::optional<std::vector<double>> numbers_from(const std::vector<std::string>& words,
                                                std::size_t first, std::size_t count) {
  std::vector<double> out;
  for (std::size_t i = first; i < first + count && i < words.size(); ++i) {
    Value word;
    word.text = words[i];
    const auto one = numbers_in(word);
    if (!one || one->size() != 1) return std::nullopt;
    out.push_back((*one)[0]);
  }
  return out.size() == count ? std::optional(out) : std::nullopt;
}

bool is_comment(const std::string& line) { return line.starts_with("#"); }

/// The lenses, by their ids.
std::map<std::string, CalibratedCamera> read_cameras(std::istream& in, Source& source) {
  std::map<std::string, CalibratedCamera> lenses;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const auto words = words_of(line);
    if (words.empty() || is_comment(line)) continue;
    const ColmapModel* model = nullptr;
    for (const ColmapModel& each : kModels)
      if (words.size() > 1 && words[1] == each.name) model = &each;
    if (model == nullptr) {
      source.error(number,
                   "isn't a camera of a model that Delos has; COLMAP's "
                   "model_converter makes OPENCV of others");
      continue;
    }
    const auto size = numbers_from(words, 2, 2);
    const auto p = numbers_from(words, 4, model->parameters);
    if (!size || !p) {
      source.error(number, std::string("a camera of the model ") + model->name +
                               " has " + std::to_string(model->parameters) +
                               " numbers");
      continue;
    }
    CalibratedCamera c;
    const std::size_t focals = model->one_focal ? 1 : 2;
    c.f = {(*p)[0], (*p)[focals - 1]};
    c.c = Eigen::Vector2d((*p)[focals], (*p)[focals + 1]).array() - 0.5;
    c.size = {(*size)[0], (*size)[1]};
    std::vector<double> k(p->begin() + static_cast<std::ptrdiff_t>(focals) + 2,
                          p->end());
    if (model->one_focal && !k.empty()) k.resize(4);  // k1 [k2], no p
    Value at;
    at.line = number;
    set_distortion(c, k, model->fisheye, at, source);
    lenses[words[0]] = c;
  }
  return lenses;
}

/// A name without what would split it: "scan/left.jpg" → "left"
std::string stem_of(const std::string& name) {
  return std::filesystem::path(name).stem().string();
}

}  // namespace

bool is_colmap(std::string_view text) {
  const std::string_view first = text.substr(0, text.find('\n'));
  return first.starts_with("# Camera list with one line of data per camera") ||
         first.starts_with("# Image list with two lines of data per image");
}

void read_colmap(const std::filesystem::path& file, const ImportOptions& options,
                 Source& source, Calibration& out) {
  const auto unit = asked_unit(options, source);
  const std::filesystem::path folder = file.parent_path();
  std::ifstream cameras(folder / "cameras.txt"), images(folder / "images.txt");
  if (!cameras || !images) {
    source.error(0,
                 "cameras.txt and images.txt must stand side by side, and one of them "
                 "isn't there");
    return;
  }
  out.facts.emplace_back(
      "a camera an image; pixels' middles at 0.5, here at 0; world to camera; scale by "
      "--unit; which way is up isn't in the file: -y is taken, as reconstructions "
      "begin");
  out.up = "-y";
  Source of_cameras = source.beside((folder / "cameras.txt").string()),
         of_images = source.beside((folder / "images.txt").string());
  const auto lenses = read_cameras(cameras, of_cameras);
  int number = 0;
  bool points = false;  // the second line of an image, which may be empty
  for (std::string line; std::getline(images, line);) {
    ++number;
    if (is_comment(line)) continue;
    if (points) {
      points = false;
      continue;
    }
    const auto words = words_of(line);
    if (words.empty()) continue;
    points = true;
    const auto v = numbers_from(words, 1, 7);
    const auto lens = words.size() > 8 ? lenses.find(words[8]) : lenses.end();
    if (!v || words.size() < 10 || lens == lenses.end()) {
      of_images.error(number,
                      "isn't an image: its id, QW QX QY QZ TX TY TZ, the id of its "
                      "camera, which cameras.txt must have, and its name");
      continue;
    }
    CalibratedCamera c = lens->second;
    c.name = stem_of(words[9]);
    c.line = number;
    const Eigen::Quaterniond q((*v)[0], (*v)[1], (*v)[2], (*v)[3]);
    if (!(std::abs(q.norm() - 1) < 0.02)) {
      of_images.error(number, "its quaternion isn't of length 1");
      continue;
    }
    c.X_WC = from_world_to_camera(
        q.normalized().toRotationMatrix(),
        unit.value_or(1) * Eigen::Vector3d((*v)[4], (*v)[5], (*v)[6]));
    out.cameras.push_back(std::move(c));
  }
}

}  // namespace delos::imports
