// Meshes as glTF has them, for tests of who reads them.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "delos/geometry/mesh.h"

namespace delos::test {

inline std::string little_endian(std::uint32_t value) {
  std::string out;
  for (int i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i) & 0xFF);
  return out;
}

/// The mesh's corners, three to a triangle as where normals differ, with y up; the
/// triangles' order is that of the mesh.
inline std::string gltf_numbers(const TriangleMesh& mesh) {
  std::string bytes;
  const auto add = [&](const void* value, std::size_t size) {
    bytes.append(static_cast<const char*>(value), size);
  };
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) {
      const Eigen::Vector3d& p = mesh.vertices[corner];
      for (const double x : {p.x(), p.z(), -p.y()}) {
        const auto number = static_cast<float>(x);
        add(&number, sizeof number);
      }
    }
  for (std::uint16_t i = 0; i < 3 * mesh.triangles.size(); ++i) add(&i, sizeof i);
  return bytes;
}

/// @param buffer what says where the numbers are, without braces
/// @param node what says where the mesh is, likewise
inline std::string gltf_json(const TriangleMesh& mesh, const std::string& buffer,
                             const std::string& node = "") {
  const std::size_t corners = 3 * mesh.triangles.size();
  const std::string count = std::to_string(corners),
                    places = std::to_string(12 * corners),
                    order = std::to_string(2 * corners),
                    all = std::to_string(14 * corners);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[1]}],"nodes":[)"
         R"({"mesh":0)" +
         (node.empty() ? "" : "," + node) +
         R"(},{"children":[0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},)"
         R"("indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
         count + R"(,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":)" +
         count + R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":)" +
         places + R"(},{"buffer":0,"byteOffset":)" + places + R"(,"byteLength":)" +
         order + R"(}],"buffers":[{"byteLength":)" + all + (buffer.empty() ? "" : ",") +
         buffer + "}]}";
}

inline std::string glb(const TriangleMesh& mesh, const std::string& node = "") {
  std::string json = gltf_json(mesh, "", node), numbers = gltf_numbers(mesh);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  numbers.resize((numbers.size() + 3) / 4 * 4, '\0');
  const auto size = [](const std::string& of) {
    return little_endian(static_cast<std::uint32_t>(of.size()));
  };
  const std::string chunks =
      size(json) + "JSON" + json + size(numbers) + std::string("BIN\0", 4) + numbers;
  return "glTF" + little_endian(2) +
         little_endian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

/// With the numbers in a data URI, in base64 (RFC 4648).
inline std::string gltf(const TriangleMesh& mesh) {
  constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string bytes = gltf_numbers(mesh);
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 |
              (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return gltf_json(mesh,
                   R"("uri":"data:application/octet-stream;base64,)" + text + '"');
}

}  // namespace delos::test
