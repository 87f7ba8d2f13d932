#include "geometry/occlusion/flat_tree.h"

#include <algorithm>
#include <limits>

#include "geometry/occlusion/float_bounds.h"

namespace delos {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

using Floats = FlatNode::Floats;  // here: x, y, z and nothing

/// Bounds that grow by what is put in.
struct Bounds {
  Floats min = Floats{} + kInfinity, max = Floats{} - kInfinity;

  void extend(const Floats& low, const Floats& high) {
    min = low < min ? low : min;
    max = high > max ? high : max;
  }
  void extend(const Bounds& b) { extend(b.min, b.max); }
  /// Half the surface's area, which is how likely a random line meets it.
  float area() const {
    const Floats size = max - min;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

struct Item {
  Bounds bounds;
  std::uint32_t box;

  Floats twice_centre() const { return bounds.min + bounds.max; }
};

/// Items in a row.
struct Range {
  Item *begin = nullptr, *end = nullptr;
  int levels = 0;  ///< how often it may be cut in two from here on
  Bounds bounds, twice_centres;

  Range() = default;
  Range(Item* first, Item* last, int levels_left)
      : begin(first), end(last), levels(levels_left) {
    for (const Item* i = begin; i != end; ++i) {
      bounds.extend(i->bounds);
      twice_centres.extend(i->twice_centre(), i->twice_centre());
    }
  }
  std::ptrdiff_t count() const { return end - begin; }
};

using Parts = std::array<Range, FlatNode::kLanes>;

/// As floats have it: x = 1.… · 2^(exponent − 127), zero where x is.
int exponent_of(float x) {
  return static_cast<int>(std::bit_cast<std::uint32_t>(x) >> 23);
}

/// A node with the boxes of these parts, without children.
FlatNode packed(std::span<const Range> parts) {
  Bounds all;
  for (const Range& part : parts) all.extend(part.bounds);
  FlatNode node = {.corner = {all.min[0], all.min[1], all.min[2]},
                   .lanes = static_cast<std::uint8_t>((1 << parts.size()) - 1)};
  for (int k = 0; k < 3; ++k) {
    const auto plane = [&](int steps) {
      return node.corner[k] + static_cast<float>(steps) * node.step(k);
    };
    const float least_step = (all.max[k] - all.min[k]) / FlatNode::kMost;
    node.exponent[k] =
        static_cast<std::uint8_t>(std::clamp(exponent_of(least_step), 1, 254));
    while (plane(FlatNode::kMost) < all.max[k]) ++node.exponent[k];
    const float steps_a_metre = 1 / node.step(k);  // exact
    for (std::size_t l = 0; l < parts.size(); ++l) {
      const Bounds& b = parts[l].bounds;
      const auto steps_to = [&](float x) {
        const float steps = (x - node.corner[k]) * steps_a_metre;
        return static_cast<int>(std::min(steps, FlatNode::kMost - 1.0f));
      };
      int low = steps_to(b.min[k]) + 1, high = steps_to(b.max[k]);
      while (plane(low) > b.min[k]) --low;
      while (plane(high) < b.max[k]) ++high;
      node.packed[0][l / 4][l % 4] |= low << (FlatNode::kBits * k);
      node.packed[1][l / 4][l % 4] |= high << (FlatNode::kBits * k);
    }
  }
  return node;
}

/// Equal parts of a range of centres, along the axis where they are farthest apart.
class Bins {
 public:
  explicit Bins(const Range& r) : count_(r.count() < 64 ? kMost / 2 : kMost) {
    const Floats sizes = r.twice_centres.max - r.twice_centres.min;
    axis_ = sizes[0] > sizes[1] ? 0 : 1;
    if (sizes[2] > sizes[axis_]) axis_ = 2;
    from_ = r.twice_centres.min[axis_];
    length_ = sizes[axis_];
    scale_ = static_cast<float>(count_) / length_;
  }
  int axis() const { return axis_; }
  bool tell_apart() const { return length_ > 0; }
  int bin_of(const Item& item) const {
    const float at = (item.twice_centre()[axis_] - from_) * scale_;
    return static_cast<int>(
        std::min(std::max(0.0f, at), static_cast<float>(count_ - 1)));
  }

  /// The first bin of the upper part.
  ///
  /// A cut is best where the areas of both parts, weighed with how many nodes they
  /// need, sum up to least: the surface-area heuristic. Source: Wald (2007), On fast
  /// construction of SAH-based bounding volume hierarchies, IEEE Symposium on
  /// Interactive Ray Tracing, 33–40.
  int best_cut(const Range& r) const {
    std::array<Bounds, kMost> bounds;
    std::array<int, kMost> items{};
    for (const Item* i = r.begin; i != r.end; ++i) {
      const int bin = bin_of(*i);
      bounds[bin].extend(i->bounds);
      ++items[bin];
    }
    std::array<float, kMost> cost_below;
    Bounds below, above;
    int count = 0;
    for (int b = 1; b < count_; ++b) {
      below.extend(bounds[b - 1]);
      count += items[b - 1];
      cost_below[b] = cost(below, count);
    }
    int best = 1;
    float least = kInfinity;
    count = 0;
    for (int b = count_ - 1; b > 0; --b) {
      above.extend(bounds[b]);
      count += items[b];
      const float sum = cost_below[b] + cost(above, count);
      if (sum < least) least = sum, best = b;
    }
    return best;
  }

 private:
  static constexpr int kMost = 16;

  /// Whole nodes, so that they come out full.
  static float cost(const Bounds& bounds, int items) {
    if (items == 0) return kInfinity;
    const int nodes = (items + FlatNode::kLanes - 1) / FlatNode::kLanes;
    return static_cast<float>(nodes) * bounds.area();
  }

  int count_, axis_;
  float from_, length_, scale_;
};

/// Reorders a range so that it can be cut in two at what is returned.
Item* cut_of(const Range& r) {
  const Bins bins(r);
  const int halvings = std::bit_width(static_cast<std::uint64_t>(r.count()));
  if (bins.tell_apart() && r.levels > halvings) {
    const int cut = bins.best_cut(r);
    Item* const middle = std::partition(
        r.begin, r.end, [&](const Item& i) { return bins.bin_of(i) < cut; });
    if (middle != r.begin && middle != r.end) return middle;
  }
  Item* const middle = r.begin + r.count() / 2;
  std::nth_element(r.begin, middle, r.end, [&](const Item& a, const Item& b) {
    return a.twice_centre()[bins.axis()] < b.twice_centre()[bins.axis()];
  });
  return middle;
}

/// The part with the largest surface of those that may_be(part); null without any.
template <class MayBe>
Range* largest_of(std::span<Range> parts, MayBe may_be) {
  Range* largest = nullptr;
  for (Range& part : parts) {
    if (!may_be(part)) continue;
    if (!largest || part.bounds.area() > largest->bounds.area()) largest = &part;
  }
  return largest;
}

/// Cuts into as many parts as a node holds. Parts that fit into a node of their own are
/// taken apart only where all their items fit into this one.
/// @returns how many there are
int split(const Range& whole, Parts& parts) {
  parts[0] = whole;
  int count = 1;
  const auto filled = [&] { return std::span(parts.data(), parts.data() + count); };
  while (count < FlatNode::kLanes) {
    Range* const part = largest_of(
        filled(), [](const Range& r) { return r.count() > FlatNode::kLanes; });
    if (!part) break;
    const Range r = *part;
    Item* const middle = cut_of(r);
    *part = Range(r.begin, middle, r.levels - 1);
    parts[count++] = Range(middle, r.end, r.levels - 1);
  }
  for (;;) {
    Range* const part = largest_of(filled(), [&](const Range& r) {
      return r.count() > 1 && r.count() - 1 <= FlatNode::kLanes - count;
    });
    if (!part) return count;
    const Range r = *part;
    *part = Range(r.begin, r.begin + 1, 0);
    for (Item* i = r.begin + 1; i != r.end; ++i) parts[count++] = Range(i, i + 1, 0);
  }
}

/// Appends nodes in depth-first order.
struct Builder {
  const Item* first;
  std::vector<FlatNode>& nodes;

  std::uint32_t add_node(const Range& whole) {
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.emplace_back();
    Parts parts;
    const int count = split(whole, parts);
    FlatNode node = packed({parts.data(), parts.data() + count});
    for (int l = 0; l < count; ++l) {
      const auto item = static_cast<std::uint32_t>(parts[l].begin - first);
      node.child[l] =
          parts[l].count() == 1 ? FlatNode::kItem | item : add_node(parts[l]);
    }
    nodes[index] = node;
    return index;
  }
};

}  // namespace

FlatTree::FlatTree(std::span<const Box> boxes) {
  if (boxes.empty()) return;
  Box all;
  for (const Box& box : boxes) all.extend(box);
  origin_ = all.center().cwiseMax(-kFarthest).cwiseMin(kFarthest);
  std::vector<Item> items(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Item& item = items[i];
    item.box = static_cast<std::uint32_t>(i);
    item.bounds = {Floats{}, Floats{}};
    for (int k = 0; k < 3; ++k) {
      item.bounds.min[k] = float_below(boxes[i].min()[k] - origin_[k]);
      item.bounds.max[k] = float_above(boxes[i].max()[k] - origin_[k]);
    }
  }
  nodes_.reserve(items.size() / 4 + 1);
  Item* const begin = items.data();
  Builder{begin, nodes_}.add_node(Range(begin, begin + items.size(), kMostLevels));
  nodes_.shrink_to_fit();
  order_.reserve(items.size());
  for (const Item& item : items) order_.push_back(item.box);
}

}  // namespace delos
