#include "delos/scene/presets.h"

#include <algorithm>

namespace delos {

std::span<const DevicePreset> device_presets() {
  static constexpr DevicePreset kPresets[] = {
      {"OptiTrack Prime 13", "camera",
       "resolution: [1280, 1024], f_x: 1201.8, f_y: 1203.6", "",
       "a calibration that Motive published as a sample: 56.1 x 46.1 deg"},
      {"Vicon MX40, 20 mm", "camera",
       "resolution: [2352, 1728], pitch: 7 um, focal: 20 mm", "",
       "MX manual: 44.8 x 33.7 deg"},
      {"Azure Kinect", "depth_camera", "depth_sigma: 17 mm, far: 3.5",
       "resolution: [640, 576], field_of_view: 75 deg",
       "Sensors 21(2):413, 2021: standard deviation of at most 17 mm up to 3.5 m; its "
       "mean error, below 11 mm, is bias"},
      {"RealSense D435", "depth_camera", "field_of_view: 90 deg",
       "resolution: [1280, 720], baseline: 50 mm, subpixel: 0.08",
       "Intel's white paper on D400 depth quality: horizontal angle; sigma_z = z^2 "
       "subpixel/(f baseline)"},
      {"RealSense D415", "depth_camera", "field_of_view: 65 deg",
       "resolution: [1280, 720], baseline: 50 mm, subpixel: 0.08",
       "Intel's white paper on D400 depth quality: horizontal angle; sigma_z = z^2 "
       "subpixel/(f baseline)"},
      {"ADIS16448", "imu",
       "rate_noise: 1.6968e-4, rate_walk: 1.9393e-5, acceleration_noise: 2.0e-3, "
       "acceleration_walk: 3.0e-3",
       "readings: 200 Hz", "configuration of the EuRoC data set"},
      {"RealSense D455", "imu",
       "rate_noise: 1.027e-4, rate_walk: 1.11e-6, acceleration_noise: 1.038e-3, "
       "acceleration_walk: 4.13e-5",
       "readings: 200 Hz", "configuration of OpenVINS, by Allan deviation"},
      {"BMI088", "imu", "rate_noise: 2.443e-4, acceleration_noise: 1.863e-3",
       "readings: 400 Hz",
       "data sheet rev 1.9, as public code quotes it: 0.014 deg/s/sqrt(Hz), 190 "
       "ug/sqrt(Hz) along its worst axis; no random walk is given"},
      {"ICM-20948", "imu", "rate_noise: 2.618e-4, acceleration_noise: 2.256e-3",
       "readings: 400 Hz",
       "DS-000189, as public code quotes it: 0.015 deg/s/sqrt(Hz), 230 ug/sqrt(Hz); no "
       "random walk is given"},
      {"SteamVR base station 1.0", "lighthouse", "generation: v1, sigma: 67e-6", "",
       "jitter of one sweep at a photodiode, 55 to 79 urad (the middle), computed from "
       "Bitcraze's positioning data set; most of it common to a deck"},
      {"SteamVR base station 2.0", "lighthouse", "generation: v2, sigma: 35e-6", "",
       "jitter of one sweep at a photodiode, 28 to 41 urad (the middle), computed from "
       "Bitcraze's positioning data set; most of it common to a deck"},
      {"Marvelmind", "range", "sigma: 2 cm", "",
       "manual, section 11.10: a range to +-2 cm, taken for its standard deviation"},
      {"Decawave DW1000", "uwb_range", "sigma: 28 mm", "",
       "white part, 20 to 36 mm (the middle), of the data sets LIAS and STAR-loc; the "
       "constant bias of a link, 0.08 to 0.36 m, is no noise; module manual, TDC P330 "
       "6.4.1: 10 cm is 3 sigma"},
  };
  return kPresets;
}

const DevicePreset* device_preset(const std::string& name) {
  const auto all = device_presets();
  const auto found = std::find_if(all.begin(), all.end(), [&](const DevicePreset& one) {
    return one.name == name;
  });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> preset_sources(const Scene& scene) {
  std::vector<std::string> lines;
  for (const DevicePreset& one : device_presets()) {
    const bool used = std::any_of(
        scene.devices.begin(), scene.devices.end(),
        [&](const DeviceEntry& device) { return device.preset == one.name; });
    if (used) lines.push_back(std::string(one.name) + ": " + one.source);
  }
  return lines;
}

}  // namespace delos
