// What a page can ask for.
#pragma once

#include <boost/asio/thread_pool.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "delos/plugin/registry.h"
#include "server/awaitable.h"
#include "server/reply.h"
#include "server/visitors.h"
#include "session/shipped_scenes.h"

namespace delos::server {

/// Answers requests about scenes. Called on the server's thread, works on the pool's.
///
/// GET  /api/scenes                                 → {first, scenes: [{id, about}]}
/// POST /api/open      {scene}                      → {session, description()}
/// POST /api/describe  {session}                    → description()
/// POST /api/around    {session}                    → surroundings()
/// POST /api/change    {session, set: [{path, value}], gesture}     → description()
/// POST /api/place     {session, device, p, R, gesture}             → description()
/// POST /api/undo, /api/redo  {session}             → description()
/// POST /api/field     {session, most}              → packed()
/// POST /api/point     {session, at}                → {point: point_json(), words,
/// ellipsoid} POST /api/worth     {session}                    → worth_json() POST
/// /api/text      {session}                    → the scene as YAML
///
/// A change stops what is being worked out of the design before; the newest request of
/// field, point or worth takes the place of the one before, which is answered by 409.
class Api {
 public:
  /// @param scene what is offered first; empty: none
  Api(std::filesystem::path scene, PluginRegistry& plugins, int threads);

  boost::asio::awaitable<Reply> answer(std::string verb, std::string body);
  [[nodiscard]] Reply scenes() const;

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
  Visitors visitors_;
};

}  // namespace delos::server
