// Where something is: the keys at, aim, roll, rpy and quaternion_wxyz.
#pragma once

#include <optional>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_at(Reader& reader, const Place& at, Placement& out);
void read_aim(Reader& reader, const Place& at, Placement& out);
void read_roll(Reader& reader, const Place& at, Placement& out);
void read_rpy(Reader& reader, const Place& at, Placement& out);
void read_quaternion(Reader& reader, const Place& at, Placement& out);

[[nodiscard]] std::optional<Node> write_at(const Placement& placement);
[[nodiscard]] std::optional<Node> write_aim(const Placement& placement);
[[nodiscard]] std::optional<Node> write_roll(const Placement& placement);
[[nodiscard]] std::optional<Node> write_rpy(const Placement& placement);
[[nodiscard]] std::optional<Node> write_quaternion(const Placement& placement);

/// What only the keys together tell: at most one says where something faces.
void check_placement(Reader& reader, const Place& at, const Placement& placement);

/// The same for something that stands elsewhere than at placement.at.
/// @param p where; null where that isn't known
void check_facing(Reader& reader, const Place& at, const Placement& placement,
                  const Eigen::Vector3d* p);

// T is anything with a Placement called placement.
template <class T>
inline constexpr Key<T> kAtKey = {
    "at",
    Need::optional,
    "position [x, y, z], metres, in its group or the world",
    shapes::vector("m"),
    [](Reader& r, const Place& p, T& t) { read_at(r, p, t.placement); },
    [](const T& t) { return write_at(t.placement); }};
template <class T>
inline constexpr Key<T> kAimKey = {
    "aim",
    Need::optional,
    "point that the z axis looks at, in the frame of `at`",
    shapes::vector("m"),
    [](Reader& r, const Place& p, T& t) { read_aim(r, p, t.placement); },
    [](const T& t) { return write_aim(t.placement); }};
template <class T>
inline constexpr Key<T> kRollKey = {
    "roll",
    Need::optional,
    "a turn about the z axis, of what is aimed",
    shapes::number("rad"),
    [](Reader& r, const Place& p, T& t) { read_roll(r, p, t.placement); },
    [](const T& t) { return write_roll(t.placement); }};
template <class T>
inline constexpr Key<T> kRpyKey = {
    "rpy",
    Need::optional,
    "orientation as [roll, pitch, yaw], Rz·Ry·Rx",
    shapes::vector("rad"),
    [](Reader& r, const Place& p, T& t) { read_rpy(r, p, t.placement); },
    [](const T& t) { return write_rpy(t.placement); }};
template <class T>
inline constexpr Key<T> kQuaternionKey = {
    "quaternion_wxyz",
    Need::optional,
    "orientation as [w, x, y, z], of any length but 0",
    shapes::numbers("1", 4, 4),
    [](Reader& r, const Place& p, T& t) { read_quaternion(r, p, t.placement); },
    [](const T& t) { return write_quaternion(t.placement); }};
template <class T>
inline constexpr std::array<Key<T>, 5> kPlacementKeys = {
    {kAtKey<T>, kAimKey<T>, kRollKey<T>, kRpyKey<T>, kQuaternionKey<T>}};

}  // namespace delos
