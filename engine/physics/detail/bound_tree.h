// physics/detail/bound_tree.h: which bodies may lie near a place, by a tree of boxes (Bullet's btDbvt). Each box is a little larger
// than its body, so that one that moves is seldom moved in the tree. What the tree looks like depends on the past; what it
// finds does not.
#pragma once
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <array>
#include <optional>
#include <span>

#include "core/maths.h"
#include "physics/physics.h"

namespace thaum::physics::detail {

struct Box {
    vec3 low{}, high{};  ///< m
};

/// As many as a place may have near it for the tree to be of use.
using NearKeys = std::array<Key, 128>;

class BoundTree {
public:
    using Leaf = btDbvtNode*;

    Leaf add(Key, const Box&);
    void move(Leaf, const Box&);
    void remove(Leaf);
    /// The keys of all whose box meets this one, and of some that miss it by little, sorted, in the first places of `into`. Nothing
    /// where they do not fit. Allocates nothing; several threads may ask.
    std::optional<std::span<const Key>> near(const Box&, NearKeys& into) const;

private:
    btDbvt tree_;
};

}  // namespace thaum::physics::detail
