#include "layers/pose_views.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "observe/point_rows.h"

namespace delos {
namespace {

/// What roundings may move a point, relative to its coordinates: a touch isn't a
/// certainty.
constexpr double kTouch = 1e-12;

const Eigen::Vector3d kNowhere =
    Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());

}  // namespace

PoseViews::PoseViews(const System& system, const PoseTrees& trees)
    : system_(system),
      trees_(trees),
      sights_(system.markers.size()),
      place_(kNowhere),
      seen_(trees.poses.size() / 64 + 1) {}

void PoseViews::append(const PlacedDevice& placed, std::vector<std::int32_t>& poses) {
  std::fill(seen_.begin(), seen_.end(), 0);
  if (placed.device->span() == Span::point) {
    const bool may_hide =
        may_be_hidden(system_, placed) && !placed.without_sight.arrives();
    // Only what looks from its origin shares its lines with what stands there.
    if (may_hide && (placed.X_WS().p != place_ || !placed.looks_from_origin())) {
      place_ = placed.looks_from_origin() ? placed.X_WS().p : kNowhere;
      for (SightsOfMarker& sights : sights_) {
        sights.asked.assign(trees_.nodes.size(), SightsOfMarker::Asked::no);
        sights.node.resize(trees_.nodes.size());
        sights.pose.assign(trees_.poses.size(), Sight::unknown);
      }
    }
    tells_balls_ = true;
    for (marker_ = 0; marker_ < system_.markers.size(); ++marker_)
      for (const std::uint32_t root : trees_.roots) {
        arm_ = trees_.poses[trees_.nodes[root].first].R * system_.markers[marker_].p;
        descend(placed, root, false, may_hide ? Sight::unknown : Sight::clear);
      }
  } else {
    see_any_span(placed);
  }
  for (std::size_t w = 0; w < seen_.size(); ++w)
    for (std::uint64_t bits = seen_[w]; bits != 0; bits &= bits - 1)
      poses.push_back(static_cast<std::int32_t>(
          64 * w + static_cast<std::size_t>(std::countr_zero(bits))));
}

void PoseViews::see_any_span(const PlacedDevice& placed) {
  const int columns = information_size(system_);
  for (std::uint32_t i = 0; i < trees_.poses.size(); ++i)
    if (measure(system_, placed, trees_.poses[i], columns, scratch_,
                [](const StateRow&) {}))
      note(i);
}

/// @param in_view whether all of the node is known to be in view
/// @param sight what is known of the lines to all of it
void PoseViews::descend(const PlacedDevice& placed, std::uint32_t at, bool in_view,
                        Sight sight) {
  const PoseTrees::Node& node = trees_.nodes[at];
  if (!in_view && tells_balls_) {
    const View view = view_of(placed, node);
    if (view == View::outside) return;
    in_view = view == View::inside;
    tells_balls_ = view != View::unknown;
  }
  if (sight == Sight::unknown) sight = sight_of(placed, at);
  if (sight == Sight::hidden) return;
  if (in_view && sight == Sight::clear) {
    for (std::uint32_t i = node.first; i < node.end; ++i) note(i);
  } else if (node.below == 0) {
    see_block(placed, node, in_view, sight);
  } else {
    descend(placed, node.below, in_view, sight);
    descend(placed, node.below + 1, in_view, sight);
  }
}

View PoseViews::view_of(const PlacedDevice& placed, const PoseTrees::Node& node) const {
  const Eigen::Vector3d middle = node.box.center();
  const double size =
      middle.norm() + arm_.norm() + placed.X_WS().p.norm() + node.box.diagonal().norm();
  const Eigen::Vector3d center = seen_at(placed.X_WS(), middle, arm_);
  const double radius = node.box.diagonal().norm() / 2 + kTouch * size;
  View view = View::unknown;
  ask(placed, [&](const Device& device) {
    view = device.view_of_ball(center, radius);
    return true;
  });
  return view;
}

Sight PoseViews::sight_of(const PlacedDevice& placed, std::uint32_t at) {
  SightsOfMarker& sights = sights_[marker_];
  if (sights.asked[at] == SightsOfMarker::Asked::no) {
    const PoseTrees::Node& node = trees_.nodes[at];
    sights.asked[at] = SightsOfMarker::Asked::yes;
    sights.node[at] = sight_of_box(system_, placed, trees_.poses[node.first].R,
                                   system_.markers[marker_], node.box);
  }
  return sights.node[at];
}

/// The poses of a leaf, one by one.
void PoseViews::see_block(const PlacedDevice& placed, const PoseTrees::Node& node,
                          bool all_in_view, Sight sight) {
  const auto block = std::span(trees_.poses).subspan(node.first, node.end - node.first);
  std::uint64_t left = all_in_view ? ~std::uint64_t{0} >> (kLanes - block.size())
                                   : in_view(placed, block);
  for (; left != 0; left &= left - 1) {
    const std::uint32_t i =
        node.first + static_cast<std::uint32_t>(std::countr_zero(left));
    if (sight == Sight::unknown) {
      Sight& own = sights_[marker_].pose[i];
      if (own == Sight::unknown)
        own = in_sight(system_, placed, trees_.poses[i], system_.markers[marker_])
                  ? Sight::clear
                  : Sight::hidden;
      if (own == Sight::hidden) continue;
    }
    note(i);
  }
}

/// The poses of a block whose marker is in view, a bit each.
std::uint64_t PoseViews::in_view(const PlacedDevice& placed,
                                 std::span<const TargetPose> block) {
  std::uint64_t seen = 0;
  if (points_in_view(placed, system_.markers[marker_], block, seen)) return seen;
  scratch_.target.R_ST.setIdentity();
  scratch_.target.own.setZero(placed.own.size);
  for (std::size_t l = 0; l < block.size(); ++l) {
    scratch_.target.p_ST = seen_at(placed.X_WS(), block[l].p, arm_);
    if (observe_target(placed, 3 + placed.own.size, scratch_.target,
                       scratch_.observation))
      seen |= std::uint64_t{1} << l;
  }
  return seen;
}

}  // namespace delos
