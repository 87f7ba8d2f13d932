#include "server/request.h"
#include "server/verbs.h"
#include "session/bodies.h"
#include "session/form_edits.h"
#include "session/scene_form.h"

namespace delos::server {
namespace {

const session::LoadedScene& room_of(const Work& work) {
  return work.visitor.design.loaded();
}

/// Taken over where there is something to change.
Reply edited(const Work& work, std::vector<Override> changes) {
  if (changes.empty()) return json_reply(described(work.visitor, work.plugins));
  return changed(work, std::move(changes), text_or_empty(work.request, "gesture"));
}

std::optional<Eigen::Vector3d> vector_if_there(const Json& request, const char* key) {
  if (!request.contains(key)) return std::nullopt;
  return numbers_at(request[key], key, 3);
}

}  // namespace

/// {}
Reply form(const Work& work) {
  Json json = session::scene_form(room_of(work), work.plugins);
  json["revision"] = work.visitor.revision;
  return json_reply(json);
}

/// {set: [{path, value}], gesture}: by the paths of the form
Reply edit(const Work& work) {
  std::vector<Override> changes = changes_asked(work.request);
  if (changes.empty()) throw BadRequest("there is nothing to change");
  return edited(work, session::edits(room_of(work).scene, std::move(changes)));
}

/// {path}
Reply copy_part(const Work& work) {
  return edited(
      work, session::copying_part(room_of(work).scene, text_at(work.request, "path")));
}

/// {path, name}
Reply rename_part(const Work& work) {
  return edited(
      work, session::renaming_part(room_of(work).scene, text_at(work.request, "path"),
                                   text_at(work.request, "name")));
}

/// {path, p, size, gesture}: a body that is moved, a box that has another size
Reply shape(const Work& work) {
  return edited(work,
                session::shaping(room_of(work).scene, text_at(work.request, "path"),
                                 vector_if_there(work.request, "p"),
                                 vector_if_there(work.request, "size")));
}

/// {what, min, max}: a box that was drawn
Reply paint(const Work& work) {
  const Eigen::Vector3d a = numbers_at(member(work.request, "min"), "min", 3),
                        b = numbers_at(member(work.request, "max"), "max", 3);
  return edited(work, session::painting(room_of(work), text_at(work.request, "what"),
                                        {a.cwiseMin(b), a.cwiseMax(b)}));
}

}  // namespace delos::server
