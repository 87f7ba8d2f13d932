#include "server/api.h"

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <stdexcept>
#include <utility>

#include "delos/device/faults.h"
#include "server/request.h"
#include "server/verbs.h"
#include "session/refusal.h"

namespace delos::server {
namespace {

namespace asio = boost::asio;

/// Enough that one tab's long field keeps no other waiting.
constexpr int kWorkers = 4;

/// Run a function on a strand of the pool.
template <class Function>
asio::awaitable<Reply> run_on(Strand strand, Function function) {
  co_return co_await asio::co_spawn(
      strand, [&function]() -> asio::awaitable<Reply> { co_return function(); },
      asio::use_awaitable);
}

/// Do it; what goes wrong in it is said in the reply.
template <class Function>
Reply guarded(const Function& function) {
  try {
    return function();
  } catch (const BadRequest& error) {
    return refusal(Status::bad_request, error.what());
  } catch (const session::Refusal& error) {
    return refusal(Status::unprocessable, error.what(), error.findings());
  } catch (const DeviceFault& error) {
    return refusal(Status::unprocessable, error.what());
  } catch (const std::invalid_argument& error) {
    return refusal(Status::unprocessable, error.what());
  } catch (const std::exception& error) {
    return refusal(Status::internal, error.what());
  }
}

/// "at line 1, column 17: …" of what the parser says.
std::string without_prefix(const std::string& what) {
  const std::size_t at = what.find("at line ");
  return at == std::string::npos ? what : what.substr(at);
}

}  // namespace

Api::Api(std::filesystem::path scene, PluginRegistry& plugins, int threads)
    : plugins_(plugins),
      threads_(threads),
      scenes_(session::shipped_scenes()),
      given_(!scene.empty()),
      pool_(kWorkers) {
  if (given_)
    scenes_.insert(scenes_.begin(), {scene.filename().string(), "", std::move(scene)});
}

Reply Api::scenes() const {
  Json list = Json::array();
  for (const session::ShippedScene& scene : scenes_)
    list.push_back({{"id", scene.id}, {"about", scene.about}});
  return json_reply(
      {{"first", given_ ? Json(scenes_.front().id) : Json()}, {"scenes", list}});
}

asio::awaitable<Reply> Api::answer(std::string verb, std::string body) {
  Json request;
  try {
    request = Json::parse(body);
  } catch (const Json::exception& error) {
    co_return refusal(Status::bad_request,
                      "the request isn't JSON: " + without_prefix(error.what()));
  }
  if (!request.is_object())
    co_return refusal(Status::bad_request, "the request must be an object {…}");
  if (verb == "open") co_return co_await open(std::move(request));
  co_return co_await ask(std::move(verb), std::move(request));
}

asio::awaitable<Reply> Api::open(Json request) {
  std::shared_ptr<Visitor> visitor;
  const Reply reply = co_await run_on(asio::make_strand(pool_.get_executor()), [&] {
    return guarded([&]() -> Reply {
      const std::string id = text_at(request, "scene");
      const auto scene =
          std::find_if(scenes_.begin(), scenes_.end(),
                       [&](const session::ShippedScene& s) { return s.id == id; });
      if (scene == scenes_.end())
        return refusal(Status::not_found, "there is no scene '" + id + "'");
      Diagnostics findings;
      auto design = session::Design::open(scene->file, plugins_, findings);
      if (!design)
        return refusal(Status::unprocessable, "the scene isn't in order", findings);
      visitor = std::make_shared<Visitor>(std::move(*design),
                                          asio::make_strand(pool_.get_executor()));
      return json_reply(described(*visitor, plugins_));
    });
  });
  if (!visitor) co_return reply;
  Json json = Json::parse(reply.body);
  json["session"] = visitors_.add(std::move(visitor));
  co_return json_reply(json);
}

asio::awaitable<Reply> Api::ask(std::string name, Json request) {
  const Verb* verb = find_verb(name);
  if (!verb) co_return refusal(Status::not_found, "there is no such request");
  std::shared_ptr<Visitor> visitor;
  const Reply known = guarded([&]() -> Reply {
    visitor = visitors_.find(text_at(request, "session"));
    return visitor ? Reply{}
                   : refusal(Status::not_found, "the session is gone; open a scene");
  });
  if (!visitor) co_return known;
  if (verb->changes) visitor->stop_all();
  const Stop stop = visitor->newest(name);
  const Strand on =
      verb->aside ? asio::make_strand(pool_.get_executor()) : visitor->strand;
  co_return co_await run_on(on, [&] {
    return guarded([&] {
      return verb->work({*visitor, request, plugins_, place_, stop.get(), threads_});
    });
  });
}

void Api::left(Visitor& visitor) {
  const auto job = visitor.searches.job();
  if (!job) return;
  const session::Phase phase = job->phase();
  visitor.waits = phase == session::Phase::running || phase == session::Phase::waiting;
  if (visitor.waits) job->pause();
}

void Api::came_back(Visitor& visitor) {
  if (!std::exchange(visitor.waits, false)) return;
  const auto job = visitor.searches.job();
  if (job && job->resume()) place_.launch(job);
}

void Api::stop() {
  visitors_.stop_all();
  place_.join();
  pool_.join();
}

}  // namespace delos::server
