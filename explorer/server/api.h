// What a page can ask for.
#pragma once

#include <boost/asio/thread_pool.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "delos/plugin/registry.h"
#include "server/awaitable.h"
#include "server/reply.h"
#include "server/search_place.h"
#include "server/visitors.h"
#include "session/shipped_scenes.h"

namespace delos::server {

/// Answers requests about scenes. Called on the server's thread, works on the pool's.
///
/// GET  /api/scenes                                 → {first, scenes: [{id, about}]}
/// POST /api/open      {scene}                      → {session, description()}
///
/// Of a design, POST with {session, …}:
///
///   describe, around, pinned        → description(), surroundings(), or that of what
///   is
///                                     pinned
///   text                            → the scene as YAML
///   palette                         → palette_json()
///   change  {set: [{path, value}], gesture}
///                                   → description(), as all that change
///   place   {device, p, R, gesture}
///   add     {type, preset, at}, copy {device, by}, mirror {device, axis},
///   remove  {device}, undo, redo, pin, unpin
///   field   {most, of: pinned}      → packed()
///   difference {most}               → packed(), of draw_difference()
///   sections {sections: [{origin, u, v}], most}
///                                   → packed()
///   point   {at}                    → {point: point_json(), words, ellipsoid, lost}
///   lattice {most}                  → {points: lattice_json()}
///   blind, worth                    → blind_json(), worth_json()
///   shapes  {shapes: […], leaves}   → packed_shapes(), of fields that were asked for
///
/// Of its searches; search_verbs.cpp says what each reads:
///
///   task                            → search_task()
///   vary, fix, search_follow, search_accept, search_reject, search_reinstate
///                                   → description()
///   search_start, select_start, front_start, search_pause, search_resume, search_lock
///                                   → searched_json()
///   searches                        → {searches: [searched_json()]}
///
/// GET /api/watch?session=…, a WebSocket: see watch().
///
/// A change stops what is being worked out of the design before; the newest request of
/// field, point or worth takes the place of the one before, which is answered by 409. A
/// search goes on beside them.
class Api {
 public:
  /// @param scene what is offered first; empty: none
  Api(std::filesystem::path scene, PluginRegistry& plugins, int threads);

  boost::asio::awaitable<Reply> answer(std::string verb, std::string body);
  [[nodiscard]] Reply scenes() const;

  /// The visitor of that name; null where there is none.
  [[nodiscard]] std::shared_ptr<Visitor> visitor(const std::string& name) {
    return visitors_.find(name);
  }
  /// Nobody watches a visitor's search any more, or somebody does again.
  void left(Visitor& visitor);
  void came_back(Visitor& visitor);

  /// Stop all work and wait for its end; whoever waits for it must still be there.
  void stop();

 private:
  boost::asio::awaitable<Reply> open(Json request);
  boost::asio::awaitable<Reply> ask(std::string verb, Json request);

  PluginRegistry& plugins_;
  int threads_;
  std::vector<session::ShippedScene> scenes_;
  bool given_;                     ///< the first of them was asked for
  boost::asio::thread_pool pool_;  // outlives the strands of visitors
  SearchPlace place_;
  Visitors visitors_;
};

}  // namespace delos::server
