// physics/detail/bound_tree.h: finds bodies near a place by a tree of bounding boxes (Bullet's btDbvt).
// Each box is slightly larger than its body, so a moving body seldom changes the tree. The structure of
// the tree depends on the past; the results of a search do not.
#pragma once
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <array>
#include <optional>
#include <span>

#include "core/maths.h"
#include "physics/physics.h"

namespace thaum::physics::detail {

struct Box {
    vec3 low{}, high{};  ///< lowest and highest corner of the box (m)
};

/// Room for the bodies that a search finds. With more bodies near a place, the tree is no faster than a
/// search of all bodies.
using NearKeys = std::array<Key, 128>;

/// Search tree of bounding boxes.
class BoundTree {
public:
    using Leaf = btDbvtNode*;

    Leaf add(Key, const Box&);
    void move(Leaf, const Box&);
    void remove(Leaf);
    /// Writes to `into` the sorted keys of all bodies whose box meets this one, and of some that narrowly
    /// miss it. Returns std::nullopt if they do not fit. Does not allocate. Several threads may call it at
    /// once.
    std::optional<std::span<const Key>> near(const Box&, NearKeys& into) const;

private:
    btDbvt tree_;
};

}  // namespace thaum::physics::detail
