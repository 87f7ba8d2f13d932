#include "server/guard.h"

#include <string>

namespace delos::server {

std::optional<Reply> refused(const Asked& asked, unsigned short port) {
  const std::string by_number = "127.0.0.1:" + std::to_string(port),
                    by_name = "localhost:" + std::to_string(port);
  if (asked.host != by_number && asked.host != by_name)
    return refusal(Status::misdirected,
                   "this server is " + by_number + " and answers to no other name");
  if (!asked.origin.empty() && asked.origin != "http://" + by_number &&
      asked.origin != "http://" + by_name)
    return refusal(Status::forbidden, "only the explorer's own page may ask");
  if (asked.method == "GET") return std::nullopt;
  if (asked.method != "POST")
    return refusal(Status::method_not_allowed, "use GET or POST");
  if (asked.content_type != "application/json")
    return refusal(Status::wrong_type, "the body must be of type application/json");
  return std::nullopt;
}

}  // namespace delos::server
