// What all work of a crew has in common.
#pragma once

#include <stdexcept>

#include "delos/optimize/crew.h"
#include "delos/scene/scene.h"

namespace delos {

/// What rank 0 asks for: the first number of its question.
enum class CrewJob : std::uint64_t { search, simulation };

/// Hold the plugins that a scene needs against those of the others. All call it.
/// @throws std::runtime_error a process has other plugins than rank 0
void compare_plugins(Crew& crew, const Scene& scene, PluginRegistry& plugins);
/// The same of one that couldn't read the scene, for the reason given.
void compare_plugins(Crew& crew, const std::string& instead);

/// What isn't refused by all processes alike is the end of their work together.
template <class Step>
auto together(Crew& crew, Step&& step) {
  try {
    return step();
  } catch (const std::invalid_argument&) {
    throw;
  } catch (...) {
    crew.abandon();
    throw;
  }
}

}  // namespace delos
