#include "server/searches.h"

#include <utility>

namespace delos::server {

Searched& Searches::begin(std::shared_ptr<session::Job> job,
                          session::VariableValues before) {
  const std::lock_guard lock(mutex_);
  if (!all_.empty()) all_.back().job->pause();
  all_.push_back({++count_, std::move(job), std::move(before)});
  if (all_.size() > kMost) all_.pop_front();
  return all_.back();
}

Searched* Searches::now() { return all_.empty() ? nullptr : &all_.back(); }

Searched* Searches::find(int number) {
  for (Searched& one : all_)
    if (one.number == number) return &one;
  return nullptr;
}

std::shared_ptr<session::Job> Searches::job() const {
  const std::lock_guard lock(mutex_);
  return all_.empty() ? nullptr : all_.back().job;
}

std::optional<session::Json> Searches::news(Watched& watched) const {
  std::shared_ptr<session::Job> job;
  {
    const std::lock_guard lock(mutex_);
    if (all_.empty()) return std::nullopt;
    job = all_.back().job;
    if (watched.number != all_.back().number) watched = {all_.back().number, 0, {}};
  }
  const std::uint64_t news = job->news();
  if (news == watched.news) return std::nullopt;
  watched.news = news;
  session::Json json = searched_json(watched.number, *job, watched.heard);
  if (json.contains("evaluations")) {
    if (!json["rounds"].empty()) watched.heard.round = json["rounds"].back()["round"];
    watched.heard.evaluations = json["evaluations"];
    if (!json["incumbents"].empty())
      watched.heard.incumbents =
          json["incumbents"].back()["number"].get<std::size_t>() + 1;
  }
  return json;
}

session::Json searched_json(int number, const session::Job& job,
                            const session::Heard& heard) {
  session::Json json{{"search", number}};
  json.update(job.json(heard));
  return json;
}

}  // namespace delos::server
