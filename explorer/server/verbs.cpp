#include "server/verbs.h"

#include "session/description.h"
#include "session/palette.h"

namespace delos::server {
namespace {

Reply describe(const Work& work) {
  return json_reply(described(work.visitor, work.plugins));
}

Reply around(const Work& work) {
  return json_reply(session::surroundings(work.visitor.design.loaded().scene));
}

Reply text(const Work& work) {
  return {Status::ok, "application/yaml", work.visitor.design.text()};
}

Reply palette(const Work& work) {
  return json_reply(session::palette_json(work.plugins));
}

Reply pinned(const Work& work) {
  return json_reply(work.visitor.pinned ? work.visitor.pinned->description : Json());
}

constexpr Verb kVerbs[] = {
    {"describe", describe, false},
    {"around", around, false},
    {"text", text, false},
    {"palette", palette, false},
    {"pinned", pinned, false},
    {"change", change, true},
    {"place", place, true},
    {"add", add, true},
    {"copy", copy, true},
    {"array", array, true},
    {"mirror", mirror, true},
    {"remove", remove, true},
    {"form", form, false},
    {"edit", edit, true},
    {"copy_part", copy_part, true},
    {"rename_part", rename_part, true},
    {"shape", shape, true},
    {"paint", paint, true},
    {"undo", undo, true},
    {"redo", redo, true},
    {"pin", pin, true},
    {"unpin", unpin, true},
    {"field", field, false},
    {"difference", difference, false},
    {"sensitivity", sensitivity, false},
    {"through", through, false},
    {"sections", sections, false},
    {"point", point, false},
    {"lattice", lattice, false},
    {"blind", blind, false},
    {"worth", worth, false},
    {"shapes", shapes, false, true},
    {"task", task, false},
    {"vary", vary, true},
    {"fix", fix, true},
    {"searches", searches, false},
    {"search_start", search_start, false},
    {"select_start", select_start, false},
    {"front_start", front_start, false},
    {"search_pause", search_pause, false},
    {"search_resume", search_resume, false},
    {"search_lock", search_lock, false},
    {"search_follow", search_follow, true},
    {"search_accept", search_accept, true},
    {"search_reject", search_reject, true},
    {"terms", terms, false},
    {"search_reinstate", search_reinstate, true},
};

}  // namespace

Reply superseded() {
  return refusal(Status::conflict, "a newer request took its place");
}

const Verb* find_verb(const std::string& name) {
  for (const Verb& verb : kVerbs)
    if (name == verb.name) return &verb;
  return nullptr;
}

Json described(Visitor& visitor, PluginRegistry& plugins) {
  Json json = session::description(visitor.design, visitor.revision, plugins);
  json["pinned"] = visitor.pinned ? visitor.pinned->description["revision"] : Json();
  return json;
}

}  // namespace delos::server
