// A room that is searched.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "client.h"

namespace delos::test {

inline constexpr auto kGlance = std::chrono::milliseconds(20);

/// Scene 10 in a folder of its own, which ends after some two hundred evaluations.
struct Room {
  Folder folder;
  std::filesystem::path file =
      folder.write("room.yaml", read_file(scene("10-better-speakers")));
  Explorer explorer{{file.string()}};
  std::string session = explorer.open("room.yaml")["session"];

  Json ask(const std::string& verb, const Json& more = Json::object()) const {
    const Answer answer = explorer.ask(verb, session, more);
    EXPECT_EQ(answer.status, 200) << verb << ": " << answer.body;
    return answer.json();
  }
  [[nodiscard]] std::string text() const { return explorer.ask("text", session).body; }
  [[nodiscard]] Json now() const { return ask("searches")["searches"].back(); }
  /// Look until it is so, two minutes at most.
  template <class So>
  Json until(So&& so) const {
    const auto last = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    for (;;) {
      Json search = now();
      if (so(search)) return search;
      if (std::chrono::steady_clock::now() > last) {
        ADD_FAILURE() << "waited in vain: " << search.dump().substr(0, 500);
        return search;
      }
      std::this_thread::sleep_for(kGlance);
    }
  }
  Json until_phase(const std::string& phase) const {
    return until([&](const Json& search) { return search["phase"] == phase; });
  }
  Json until_found(std::size_t incumbents) const {
    return until(
        [&](const Json& search) { return search["incumbents"].size() >= incumbents; });
  }
  /// The values of the variables, from the design's text.
  [[nodiscard]] Json variables() const {
    Json values;
    const Json task = ask("task");
    for (const Json& v : task["variables"])
      values[v["path"].get<std::string>()] = v["value"];
    return values;
  }
};

}  // namespace delos::test
