#include "physics/detail/triangle_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "core/assert.h"
#include "physics/detail/cast.h"

namespace thaum::physics::detail {
namespace {

/// Largest number of triangles that a search collects before it measures them.
constexpr std::size_t most_collected = 128;
constexpr float boundless = std::numeric_limits<float>::infinity();

float below(double x) { return std::nextafter(static_cast<float>(x), -boundless); }
float above(double x) { return std::nextafter(static_cast<float>(x), boundless); }

/// The number that has `count` others before it in order; the greatest number if there are no more. Reorders
/// the numbers.
double least_but(std::size_t count, std::span<double> numbers) {
    if (numbers.size() <= count) return std::numeric_limits<double>::max();
    const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(count);
    std::nth_element(numbers.begin(), at, numbers.end());
    return *at;
}

}  // namespace

/// A search on its way through the tree.
struct TriangleTree::Search {
    vec3 point;
    std::array<float, 3> near;  ///< the point, rounded to single precision (m)
    double margin;              ///< largest error of a box's distance by rounding (m)
    Nearby found;               ///< the body to which all triangles belong; each triangle's own fields follow
    NearestSurfaces& into;
    /// Distance beyond which no triangle is wanted (m), and the square of that of a box.
    double limit{};
    float limit2{};
    std::array<std::size_t, most_collected> collected{};  ///< triangles whose boxes are within the limit
    std::size_t count = 0;
    bool overflows = false;  ///< there are more triangles within the limit than `collected` holds
    bool at_once = false;    ///< each triangle is measured and given to the result when it is met

    void set_limit(double distance) {
        // Factor that covers the rounding of a large distance's square to single precision.
        constexpr double rounding = 1 + 1e-6;
        limit = distance;
        limit2 = above(rounding * (limit + margin) * (limit + margin));
    }

    /// Which of a node's eight boxes may hold what is wanted, one bit each.
    unsigned wanted_boxes(const Node& node) const {
        const auto near2 = distances2(node);
        unsigned bits = 0;
        for (std::size_t i = 0; i < width; ++i)
            bits |= node.is_used(i) && !(near2[i] > limit2) ? 1U << i : 0U;
        return bits;
    }

    /// Squares of the distances of a node's eight boxes from the point.
    std::array<float, width> distances2(const Node& node) const {
        std::array<float, width> sum{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < width; ++i) {
                const float under = node.low[axis][i] - near[axis], over = near[axis] - node.high[axis][i];
                const float gap = std::max(std::max(under, over), 0.0F);
                sum[i] += gap * gap;
            }
        }
        return sum;
    }

    void begin_again() {
        count = 0;
        overflows = false;
    }

    void give(const Triangle& triangle, double distance) {
        found.distance = distance;
        found.a = triangle.corners[0];
        found.b = triangle.corners[1];
        found.c = triangle.corners[2];
        found.part = triangle.part;
        add(into, found);
    }

    void give_if_wanted(const Triangle& triangle) {
        const double distance = distance_to_triangle(triangle.corners, point);
        if (!wanted(into, distance)) return;
        give(triangle, distance);
        if (into.found.reach < limit) set_limit(into.found.reach);
    }

    /// Gives those of the collected triangles to the result for which it may have room, and the next one,
    /// which limits its reach.
    void give_nearest(std::span<const Triangle> triangles) {
        std::array<double, most_collected> distances, sorted;
        std::size_t measured = 0;
        for (std::size_t i = 0; i < count; ++i) {
            distances[i] = distance_to_triangle(triangles[collected[i]].corners, point);
            if (distances[i] <= limit) sorted[measured++] = distances[i];  // false for a NaN
        }
        const double last = std::min(limit, least_but(into.into.size(), std::span(sorted).first(measured)));
        for (std::size_t i = 0; i < count; ++i) {
            if (distances[i] <= last) give(triangles[collected[i]], distances[i]);
        }
    }
};

TriangleTree::TriangleTree(const TriangleMesh& mesh, std::span<const std::uint32_t> order) {
    THAUM_ASSERT(order.size() == mesh.triangles.size(), "an order of triangles that leaves some out");
    // Boxes of all triangles, then of all nodes of the level before.
    std::vector<std::array<std::array<float, 3>, 2>> boxes;
    for (const std::uint32_t part : order) {
        const auto& [a, b, c] = mesh.triangles[part];
        const Triangle t{{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, part};
        triangles_.push_back(t);
        const vec3 low = glm::min(glm::min(t.corners[0], t.corners[1]), t.corners[2]);
        const vec3 high = glm::max(glm::max(t.corners[0], t.corners[1]), t.corners[2]);
        boxes.push_back(
            {{{below(low.x), below(low.y), below(low.z)}, {above(high.x), above(high.y), above(high.z)}}});
    }
    do {
        Node empty;
        for (auto& lows : empty.low) lows.fill(boundless);
        for (auto& highs : empty.high) highs.fill(-boundless);
        std::vector<Node>& nodes = levels_.emplace_back((boxes.size() + width - 1) / width, empty);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                nodes[i / width].low[axis][i % width] = boxes[i][0][axis];
                nodes[i / width].high[axis][i % width] = boxes[i][1][axis];
            }
        }
        boxes.resize(nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                boxes[i][0][axis] = std::ranges::min(nodes[i].low[axis]);
                boxes[i][1][axis] = std::ranges::max(nodes[i].high[axis]);
            }
        }
    } while (boxes.size() > 1);
}

void TriangleTree::visit(std::size_t level, std::size_t node, Search& search) const {
    for (unsigned bits = search.wanted_boxes(levels_[level][node]); bits != 0; bits &= bits - 1) {
        const std::size_t child = node * width + static_cast<std::size_t>(std::countr_zero(bits));
        if (level > 0)
            visit(level - 1, child, search);
        else if (search.at_once)
            search.give_if_wanted(triangles_[child]);
        else if (search.count < most_collected)
            search.collected[search.count++] = child;
        else
            search.overflows = true;
        if (search.overflows) return;
    }
}

/// Distance within which there are more triangles than the result has room for, so that those beyond it can
/// neither be in it nor limit its reach (m); the greatest number if too few were measured.
double TriangleTree::distance_of_enough(const Search& search) const {
    struct Box {
        float distance2;
        std::size_t child;
    };
    constexpr std::size_t most_nodes = 8;
    std::array<std::size_t, most_nodes> nodes{};
    std::array<Box, most_nodes * width> boxes;
    std::size_t node_count = 1, count = 0;
    for (std::size_t level = levels_.size(); level-- > 0;) {
        count = 0;
        for (std::size_t n = 0; n < node_count; ++n) {
            const Node& node = levels_[level][nodes[n]];
            const auto near2 = search.distances2(node);
            for (std::size_t i = 0; i < width; ++i)
                if (node.is_used(i)) boxes[count++] = {near2[i], nodes[n] * width + i};
        }
        if (level == 0) break;
        node_count = std::min(count, most_nodes);
        const auto all = std::span(boxes).first(count);
        std::ranges::partial_sort(all, all.begin() + static_cast<std::ptrdiff_t>(node_count), {},
                                  &Box::distance2);
        for (std::size_t n = 0; n < node_count; ++n) nodes[n] = boxes[n].child;
    }
    std::array<double, most_nodes * width> distances;
    std::size_t measured = 0;
    for (std::size_t i = 0; i < count; ++i) {
        // That of a triangle hardly wider than a line may be computed as less than that of its box.
        const double distance =
            std::max(distance_to_triangle(triangles_[boxes[i].child].corners, search.point),
                     std::sqrt(double{boxes[i].distance2}));
        if (std::isfinite(distance)) distances[measured++] = distance;
    }
    return least_but(search.into.into.size(), std::span(distances).first(measured));
}

void TriangleTree::gather(vec3 point, const Nearby& body, NearestSurfaces& into) const {
    if (levels_.empty()) return;
    const vec3 size = glm::abs(point);
    Search search{
        .point = point,
        .near = {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)},
        .margin = 1e-6 * (1 + std::max({size.x, size.y, size.z})),
        .found = body,
        .into = into};
    search.set_limit(into.found.reach);
    const std::size_t top = levels_.size() - 1;
    visit(top, 0, search);
    if (const double enough = search.overflows ? distance_of_enough(search) : HUGE_VAL;
        enough < search.limit) {
        search.set_limit(enough);
        search.begin_again();
        visit(top, 0, search);
    }
    if (!search.overflows) return search.give_nearest(triangles_);
    // Very many are at one distance, as around the tip of a fan.
    search.at_once = true;
    search.begin_again();
    visit(top, 0, search);
}

}  // namespace thaum::physics::detail
