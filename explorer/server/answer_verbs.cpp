#include "server/request.h"
#include "server/verbs.h"
#include "session/blind_json.h"
#include "session/device_worth.h"
#include "session/ellipsoids.h"
#include "session/named.h"
#include "session/point_answer.h"
#include "session/sections.h"
#include "session/sensitivity.h"
#include "session/surface_through.h"

namespace delos::server {
namespace {

using session::LoadedScene;

/// Samples that devices are weighed on, and that blind regions are made of.
constexpr std::size_t kWorthSamples = 4000;
/// Cuts that a page may ask for at once, and points of a lattice.
constexpr std::size_t kMostSections = 16, kMostLattice = 1000, kMostRegions = 12;
/// Samples of a cut, where the page doesn't say.
constexpr std::size_t kSectionSamples = 10'000, kMostSectionSamples = 100'000;
/// Metres: more than any room is high.
constexpr double kMostRelief = 1e6;

FieldOptions options_of(const Work& work) {
  FieldOptions options;
  options.threads = work.threads;
  options.cancel = work.stop;
  return options;
}

/// @param kind as shapes() calls the field
Reply packed_reply(const Work& work, const char* kind, session::DrawnField drawn) {
  if (*work.stop) return superseded();
  Reply reply{Status::ok, "application/octet-stream",
              session::packed(drawn, work.visitor.revision)};
  work.visitor.fields.keep(kind, work.visitor.revision, std::move(drawn));
  return reply;
}

/// An answer with the revision that it is of.
Reply revised(const Work& work, Json json) {
  if (*work.stop) return superseded();
  json["revision"] = work.visitor.revision;
  return json_reply(json);
}

/// How a surface goes through samples, as a page asks for it.
session::Through through_of(const Json& request) {
  session::Through through;
  through.how.method =
      session::scattered_method_named(text_at(request, "method"), "method");
  through.axis = session::axis_named(text_at(request, "over"), "over");
  through.relief = number_or(request, "relief", 0, kMostRelief);
  through.how.power = number_or(request, "power", through.how.power, 20, 1);
  const double radius = number_or(request, "radius", 0, kMostRelief);
  if (radius > 0) through.how.radius = radius;
  return through;
}

session::Baseline& baseline(const Work& work) {
  if (!work.visitor.pinned) throw BadRequest("no design is pinned");
  return work.visitor.pinned->baseline;
}

session::DrawnField drawn_difference(const Work& work) {
  return session::draw_difference(work.visitor.design.loaded(), baseline(work),
                                  most_samples(work.request), options_of(work));
}

session::DrawnField drawn_slopes(const Work& work) {
  return session::draw_sensitivity(
             work.visitor.design.loaded(), text_or_empty(work.request, "path"),
             most_samples(work.request), options_of(work), work.plugins)
      .drawn;
}

}  // namespace

Reply field(const Work& work) {
  const std::string of = text_or_empty(work.request, "of");
  if (!of.empty() && of != "pinned") throw BadRequest("'of' must be pinned, or absent");
  const LoadedScene& loaded =
      of.empty() ? work.visitor.design.loaded() : baseline(work).loaded;
  return packed_reply(
      work, of.empty() ? "field" : "pinned",
      session::draw_field(loaded, most_samples(work.request), options_of(work)));
}

Reply difference(const Work& work) {
  return packed_reply(work, "difference", drawn_difference(work));
}

Reply sensitivity(const Work& work) {
  return packed_reply(work, "sensitivity", drawn_slopes(work));
}

Reply through(const Work& work) {
  const session::Through how = through_of(work.request);
  const std::string of = text_or_empty(work.request, "of");
  if (!of.empty() && of != "field" && of != "difference" && of != "sensitivity")
    throw BadRequest("'of' must be field, difference or sensitivity");
  const session::DrawnField drawn =
      of == "difference" ? drawn_difference(work)
      : of == "sensitivity"
          ? drawn_slopes(work)
          : session::draw_field(work.visitor.design.loaded(),
                                most_samples(work.request), options_of(work));
  if (*work.stop) return superseded();
  return packed_reply(work, "through", session::surface_through(drawn, how));
}

Reply sections(const Work& work) {
  const Json& list = member(work.request, "sections");
  if (!list.is_array() || list.empty() || list.size() > kMostSections)
    throw BadRequest("'sections' must be a list of 1 to 16 of {origin, u, v}");
  std::vector<session::Section> all;
  for (const Json& one : list) {
    if (!one.is_object()) throw BadRequest("a section must be {origin, u, v}");
    all.push_back({numbers_at(member(one, "origin"), "origin", 3),
                   numbers_at(member(one, "u"), "u", 3),
                   numbers_at(member(one, "v"), "v", 3)});
    if (all.back().u.cross(all.back().v).norm() < 1e-12)
      throw BadRequest("'u' and 'v' must span a section");
  }
  const std::size_t asked = most_samples(work.request);
  const std::size_t most =
      asked > 0 ? std::min(asked, kMostSectionSamples) : kSectionSamples;
  const std::string of = text_or_empty(work.request, "of");
  if (!of.empty() && of != "difference")
    throw BadRequest("'of' must be difference, or absent");
  const LoadedScene& loaded = work.visitor.design.loaded();
  return packed_reply(work, "sections",
                      of.empty()
                          ? session::draw_sections(loaded, all, most, options_of(work))
                          : session::draw_difference_sections(
                                loaded, baseline(work), all, most, options_of(work)));
}

Reply point(const Work& work) {
  const Eigen::Vector3d at = numbers_at(member(work.request, "at"), "at", 3);
  const LoadedScene& loaded = work.visitor.design.loaded();
  const session::PointAnswer answer = session::answer_point(
      loaded, at, loaded.scene.orientations.rpy.front(), Solver::automatic);
  const FusedState& state = answer.report.state;
  return revised(work, {{"point", session::point_json(answer, loaded)},
                        {"words", session::lost_words(answer, loaded)},
                        {"ellipsoid", session::ellipsoid_json(loaded.system, state)},
                        {"lost", session::lost_json(loaded.system, state)}});
}

Reply lattice(const Work& work) {
  const std::size_t asked = most_samples(work.request);
  return revised(
      work, {{"points", session::lattice_json(
                            work.visitor.design.loaded(),
                            asked > 0 ? std::min(asked, kMostLattice) : kMostLattice,
                            options_of(work))}});
}

Reply blind(const Work& work) {
  const LoadedScene& loaded = work.visitor.design.loaded();
  bool fewer = false;
  const Field field = evaluate_field(
      loaded.system, session::drawn_samples(loaded.scene, kWorthSamples, fewer),
      loaded.scene.orientations, loaded.metric, options_of(work));
  if (*work.stop) return superseded();
  return revised(work, session::blind_json(loaded, field, kMostRegions));
}

Reply worth(const Work& work) {
  const LoadedScene& loaded = work.visitor.design.loaded();
  const Samples samples =
      make_samples(session::coarser(loaded.scene.samples, kWorthSamples));
  const auto all = session::device_worth(loaded, samples, options_of(work));
  if (*work.stop) return superseded();
  return revised(work, session::worth_json(all, samples));
}

}  // namespace delos::server
