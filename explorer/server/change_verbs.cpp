#include <algorithm>

#include "server/request.h"
#include "server/verbs.h"
#include "session/faces.h"
#include "session/more_devices.h"
#include "session/placing.h"

namespace delos::server {
namespace {

std::string gesture_of(const Work& work) {
  return text_or_empty(work.request, "gesture");
}

/// The first way that leaves the scene in order, else what is wrong with the first.
Reply changed_somehow(const Work& work, const session::Ways& ways) {
  if (const auto* why = std::get_if<std::string>(&ways))
    return refusal(Status::unprocessable, *why);
  std::optional<Reply> first;
  for (const std::vector<Override>& way : std::get<0>(ways)) {
    Reply reply = changed(work, way, gesture_of(work));
    if (reply.status == Status::ok) return reply;
    if (!first) first = std::move(reply);
  }
  return first.value_or(refusal(Status::unprocessable, "there is no way to do it"));
}

const session::LoadedScene& loaded_of(const Work& work) {
  return work.visitor.design.loaded();
}

/// Where a device that is moved to p goes, and how it is turned there.
void stick(const Work& work, const Json& how, Eigen::Vector3d& p,
           std::optional<Eigen::Matrix3d>& R) {
  constexpr double kUsual = 0.05, kFarthest = 1;
  if (!how.is_object()) throw BadRequest("'stick' must be {within, turn, ray}");
  const std::string device = text_at(work.request, "device");
  const session::Faces faces(loaded_of(work), device);
  std::optional<session::Contact> contact;
  if (how.contains("ray")) {
    const Json& ray = how["ray"];
    if (!ray.is_object()) throw BadRequest("'ray' must be {from, along}");
    const Eigen::Vector3d from = numbers_at(member(ray, "from"), "from", 3),
                          along = numbers_at(member(ray, "along"), "along", 3);
    if (along.norm() < 1e-9) throw BadRequest("'along' has no length");
    contact = faces.first(from, along);
  }
  if (!contact) contact = faces.nearest(p, number_or(how, "within", kUsual, kFarthest));
  if (!contact) return;
  p = contact->p;
  const Json turn = how.value("turn", Json(false));
  if (!turn.is_boolean()) throw BadRequest("'turn' must be true or false");
  if (!turn.get<bool>()) return;
  for (const PlacedDevice& placed : loaded_of(work).system.devices)
    if (placed.name == device && !placed.carried())
      R = session::turned_to(placed.X_WS().R, contact->normal);
}

/// After undo and redo: where there was nothing to do, all stays.
Reply stepped(const Work& work, bool done) {
  if (done) {
    ++work.visitor.revision;
    tell_search(work.visitor);
  }
  return json_reply(described(work.visitor, work.plugins));
}

}  // namespace

Reply changed(const Work& work, std::vector<Override> changes,
              const std::string& gesture) {
  if (changes.empty()) throw BadRequest("there is nothing to change");
  Diagnostics findings;
  if (!work.visitor.design.change(std::move(changes), gesture, work.plugins,
                                  findings)) {
    return refusal(Status::unprocessable,
                   findings.empty() ? "" : findings.front().message, findings);
  }
  ++work.visitor.revision;
  tell_search(work.visitor);
  return json_reply(described(work.visitor, work.plugins));
}

std::vector<Override> changes_asked(const Json& request) {
  const Json& set = member(request, "set");
  if (!set.is_array()) throw BadRequest("'set' must be a list of {path, value}");
  std::vector<Override> changes;
  for (const Json& one : set) {
    if (!one.is_object()) throw BadRequest("'set' must be a list of {path, value}");
    changes.push_back({text_at(one, "path"), text_at(one, "value")});
  }
  return changes;
}

Reply change(const Work& work) {
  return changed(work, changes_asked(work.request), gesture_of(work));
}

/// {device, p, q, stick: {within, turn, ray: {from, along}}}: a device that is to stick
/// goes to the face that the ray meets, else to one that is near enough; else to p
Reply place(const Work& work) {
  const Json& request = work.request;
  std::optional<Eigen::Vector3d> p;
  std::optional<Eigen::Matrix3d> R;
  if (request.contains("p")) p = numbers_at(request["p"], "p", 3);
  if (request.contains("q")) {
    const Eigen::Vector4d q = numbers_at(request["q"], "q", 4);
    if (q.norm() < 1e-6) throw BadRequest("'q' has no length");
    R = Eigen::Quaterniond(q(0), q(1), q(2), q(3)).normalized().toRotationMatrix();
  }
  if (p && request.contains("stick")) stick(work, request["stick"], *p, R);
  auto changes =
      session::placing(loaded_of(work).scene, text_at(request, "device"), p, R);
  if (const auto* why = std::get_if<std::string>(&changes))
    return refusal(Status::unprocessable, *why);
  return changed(work, std::get<std::vector<Override>>(std::move(changes)),
                 gesture_of(work));
}

Reply add(const Work& work) {
  std::optional<Eigen::Vector3d> at;
  if (work.request.contains("at")) at = numbers_at(work.request["at"], "at", 3);
  return changed_somehow(
      work, session::adding(loaded_of(work), text_at(work.request, "type"),
                            text_or_empty(work.request, "preset"), at, work.plugins));
}

Reply copy(const Work& work) {
  Eigen::Vector3d by = Eigen::Vector3d::Zero();
  if (work.request.contains("by")) by = numbers_at(work.request["by"], "by", 3);
  return changed_somehow(
      work, session::copying(loaded_of(work), text_at(work.request, "device"), by));
}

Reply array(const Work& work) {
  const Json& count = member(work.request, "copies");
  if (!count.is_number_integer()) throw BadRequest("'copies' must be a whole number");
  const auto copies = static_cast<int>(
      std::clamp<std::int64_t>(count.get<std::int64_t>(), 0, session::kMostCopies + 1));
  const std::string device = text_at(work.request, "device");
  const bool circle = work.request.contains("around");
  const char* key = circle ? "around" : "by";
  const Eigen::Vector3d at = numbers_at(member(work.request, key), key, 3);
  auto changes = circle ? session::in_a_circle(loaded_of(work), device, copies, at)
                        : session::in_a_row(loaded_of(work), device, copies, at);
  if (const auto* why = std::get_if<std::string>(&changes))
    return refusal(Status::unprocessable, *why);
  return changed(work, std::get<std::vector<Override>>(std::move(changes)),
                 gesture_of(work));
}

Reply mirror(const Work& work) {
  const std::string axes = "xyz", axis = text_at(work.request, "axis");
  const std::size_t which = axes.find(axis);
  if (axis.size() != 1 || which == std::string::npos)
    throw BadRequest("'axis' must be x, y or z");
  return changed_somehow(
      work, session::mirroring(loaded_of(work), text_at(work.request, "device"),
                               static_cast<int>(which)));
}

Reply remove(const Work& work) {
  return changed_somehow(
      work, session::removing(loaded_of(work), text_at(work.request, "device")));
}

Reply undo(const Work& work) {
  return stepped(work, work.visitor.design.undo(work.plugins));
}

Reply redo(const Work& work) {
  return stepped(work, work.visitor.design.redo(work.plugins));
}

Reply pin(const Work& work) {
  Json description = described(work.visitor, work.plugins);
  work.visitor.pinned = Pinned{{loaded_of(work), {}}, std::move(description)};
  return json_reply(described(work.visitor, work.plugins));
}

Reply unpin(const Work& work) {
  work.visitor.pinned.reset();
  return json_reply(described(work.visitor, work.plugins));
}

}  // namespace delos::server
