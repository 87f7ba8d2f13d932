// Who may ask: pages that this server gave, by its own name, and nobody else's.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "server/reply.h"

namespace delos::server {

/// Largest body of a request, bytes.
inline constexpr std::size_t kMostBody = 256 * 1024;

/// What of a request tells where it comes from.
struct Asked {
  std::string_view method, target;
  std::string_view host;          ///< empty: none
  std::string_view origin;        ///< empty: none
  std::string_view content_type;  ///< empty: none
};

/// Why a request isn't answered; nullopt where it is.
///
/// A foreign name in `Host` is a name that somebody made lead here (DNS rebinding); a
/// foreign `Origin`, another site's page. A body that claims to be JSON can't come from
/// a form of one.
[[nodiscard]] std::optional<Reply> refused(const Asked& asked, unsigned short port);

}  // namespace delos::server
