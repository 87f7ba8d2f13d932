#include "session/motion_json.h"

namespace delos::session {
namespace {

Json estimate(const motion::Estimate& e) {
  return {{"value", number(e.value)}, {"low", number(e.low)}, {"high", number(e.high)}};
}

const char* word_of(motion::Edge edge) {
  switch (edge) {
    case motion::Edge::none:
      break;
    case motion::Edge::no_noise:
      return "no_noise";
    case motion::Edge::no_motion:
      return "no_motion";
  }
  return "none";
}

}  // namespace

Json motion_json(const motion::MotionFit& fit, const std::string& source) {
  Json json{{"file", source},
            {"track", fit.track},
            {"dt", number(fit.dt)},
            {"frames", fit.frames},
            {"gaps", fit.gaps},
            {"fits", fit.fits},
            {"still", fit.still},
            {"best", motion::type_of_order(fit.best + 1)},
            {"likeliest", motion::type_of_order(fit.likeliest + 1)},
            {"orders", Json::array()}};
  for (const motion::OrderFit& order : fit.orders) {
    Json of{{"type", motion::type_of_order(order.axes[0].order)},
            {"bayes", number(order.bayes)},
            {"p_value", number(order.p_value)},
            {"axes", Json::array()}};
    for (const motion::ChainFit& axis : order.axes)
      of["axes"].push_back({{"q", estimate(axis.q)},
                            {"r", estimate(axis.r)},
                            {"edge", word_of(axis.edge)},
                            {"ljung_box", number(axis.ljung_box)},
                            {"lags", axis.lags},
                            {"p_value", number(axis.p_value)},
                            {"first_correlation", number(axis.first_correlation)}});
    json["orders"].push_back(of);
  }
  json["motion"] = motion::motion_block(fit, source);
  return json;
}

Json segments_json(const std::vector<motion::Segment>& segments,
                   const std::string& source) {
  Json json{{"segments", Json::array()},
            {"motions", motion::motions_block(segments, source)}};
  for (const motion::Segment& s : segments) {
    Json one = motion_json(s.fit, source);
    one["from"] = number(s.from);
    one["to"] = number(s.to);
    json["segments"].push_back(std::move(one));
  }
  return json;
}

}  // namespace delos::session
