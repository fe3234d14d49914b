// physics/detail/triangle_tree.h: finds the triangles of a mesh near a point.
//
// The triangles stand in one order, and eight neighbours of it have a node, as have eight neighbouring nodes,
// up to one node. So a tree over an order that keeps near triangles together is wide and flat, and a node's
// eight boxes are compared with a point at once.
//
// A search goes through the order from its begin to its end, because the result is in that order, too. It
// collects the triangles whose boxes are near, measures them, and gives the nearest ones to the result. Where
// a mesh has more triangles near the point than it can collect, it measures those of some of the nearest
// nodes, learns from them within which distance there are enough triangles, and begins again with that.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths.h"
#include "physics/detail/gather.h"
#include "physics/physics.h"

namespace thaum::physics::detail {

/// Search tree over the triangles of a mesh that never changes.
class TriangleTree {
public:
    TriangleTree() = default;
    /// `order` names each triangle of the mesh once, those near each other at neighbouring places.
    TriangleTree(const TriangleMesh& mesh, std::span<const std::uint32_t> order);

    /// Adds the triangles that are within `into.found.reach` of a point (frame of the mesh), in their order.
    /// `body` says what else is to be known of each.
    void gather(vec3 point, const Nearby& body, NearestSurfaces& into) const;

private:
    static constexpr std::size_t width = 8;

    /// Boxes of eight triangles, or of eight nodes below (m, frame of the mesh). They are rounded outward,
    /// and inside out where a node has fewer than eight.
    struct Node {
        std::array<std::array<float, width>, 3> low, high;
        bool is_used(std::size_t i) const { return low[0][i] <= high[0][i]; }
    };
    struct Triangle {
        vec3 corners[3];
        std::uint32_t part;  ///< index in the mesh
    };
    struct Search;

    void visit(std::size_t level, std::size_t node, Search& search) const;
    double distance_of_enough(const Search& search) const;

    std::vector<Triangle> triangles_;
    std::vector<std::vector<Node>> levels_;  ///< from the nodes of triangles to the node of all
};

}  // namespace thaum::physics::detail
