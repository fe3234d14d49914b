#include "physics/detail/bound_tree.h"

#include <algorithm>
#include <bit>

#include "physics/detail/bullet_world.h"

namespace thaum::physics::detail {
namespace {

constexpr double slack = 0.1;  // distance by which a box is larger than its body on each side (m)

btDbvtVolume volume_of(const Box& box, double margin) {
    return btDbvtVolume::FromMM(to_bullet(box.low - margin), to_bullet(box.high + margin));
}

struct Collect : btDbvt::ICollide {
    NearKeys& into;
    std::size_t count = 0;

    explicit Collect(NearKeys& keys) : into(keys) {}
    void Process(const btDbvtNode* leaf) override {
        if (count < into.size()) into[count] = static_cast<Key>(leaf->dataAsInt);
        ++count;
    }
};

}  // namespace

BoundTree::Leaf BoundTree::add(Key key, const Box& box) {
    Leaf leaf = tree_.insert(volume_of(box, slack), nullptr);
    leaf->dataAsInt = std::bit_cast<int>(key);
    return leaf;
}

void BoundTree::move(Leaf leaf, const Box& box) {
    if (leaf->volume.Contain(volume_of(box, 0))) return;
    btDbvtVolume larger = volume_of(box, slack);
    tree_.update(leaf, larger);
}

void BoundTree::remove(Leaf leaf) { tree_.remove(leaf); }

std::optional<std::span<const Key>> BoundTree::near(const Box& box, NearKeys& into) const {
    Collect found(into);
    tree_.collideTV(tree_.m_root, volume_of(box, 0), found);
    if (found.count > into.size()) return std::nullopt;
    std::sort(into.begin(), into.begin() + static_cast<std::ptrdiff_t>(found.count));
    return std::span(into).first(found.count);
}

}  // namespace thaum::physics::detail
