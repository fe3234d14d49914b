// Tests of the keys (the shapes hidden in crystals) and of the rough crystals around them, over many seeds.
#include "game/stations/crystal/crystal_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "game/components/crystal.h"
#include "game/stations/crystal/chisel.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

constexpr std::size_t side = crystal_side;
constexpr float solid = 0.5F;

vec3 place_of(std::size_t voxel) {
    return vec3(voxel % side, voxel / side % side, voxel / (side * side)) - 0.5 * (side - 1);
}

/// Number of solid voxels that can be reached from the first one through shared faces.
std::size_t connected_voxels(const std::vector<float>& density) {
    std::vector<bool> seen(density.size());
    const auto first = std::find_if(density.begin(), density.end(), [](float d) { return d >= solid; });
    std::vector<std::size_t> open{static_cast<std::size_t>(first - density.begin())};
    seen[open[0]] = true;
    for (std::size_t next = 0; next < open.size(); ++next) {
        const auto at = open[next];
        const auto visit = [&](bool inside, std::size_t to) {
            if (!inside || seen[to] || density[to] < solid) return;
            seen[to] = true;
            open.push_back(to);
        };
        const auto x = at % side, y = at / side % side, z = at / (side * side);
        visit(x > 0, at - 1), visit(x + 1 < side, at + 1);
        visit(y > 0, at - side), visit(y + 1 < side, at + side);
        visit(z > 0, at - side * side), visit(z + 1 < side, at + side * side);
    }
    return open.size();
}

struct Counts {
    std::size_t key{}, both{}, either{};
    vec3 reach{};  ///< greatest distance of the hidden key's voxels from the middle, along each axis (voxels)
};

Counts counts_of(const std::vector<float>& key, const std::vector<float>& rough) {
    Counts counts;
    for (std::size_t i = 0; i < key.size(); ++i) {
        const bool wanted = key[i] >= solid, there = rough[i] >= solid;
        counts.key += wanted ? 1 : 0;
        counts.both += wanted && there ? 1 : 0;
        counts.either += wanted || there ? 1 : 0;
        if (wanted) counts.reach = glm::max(counts.reach, glm::abs(place_of(i)));
    }
    return counts;
}

TEST(CrystalShape, KeysOfAThousandSeedsAreInOnePieceAndHalfCarved) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const auto key = key_density(seed, crystal_side);
        const auto rough = rough_density(seed, key, crystal_side);
        ASSERT_EQ(key.size(), crystal_voxels);
        const auto counts = counts_of(key, rough);
        EXPECT_GT(counts.key, 1000U) << seed;
        EXPECT_LT(counts.key, 2500U) << seed;
        EXPECT_EQ(connected_voxels(key), counts.key) << seed;
        const double overlap = static_cast<double>(counts.both) / static_cast<double>(counts.either);
        EXPECT_GT(overlap, 0.4) << seed;
        EXPECT_LT(overlap, 0.65) << seed;
        ASSERT_TRUE(std::ranges::all_of(rough, [](float d) { return d >= 0 && d <= 1; })) << seed;
    }
}

// A hand can reach the whole length and height of a key (the shape that is hidden in a crystal), and half its
// thickness from either side.
TEST(CrystalShape, AHandReachesEveryPartOfAKey) {
    const auto data = duel_data();
    const auto& hand = data->crystal->hand;
    const vec3 half = 0.5 * data->device.workspace * hand.metres_per_metre;
    constexpr double voxel = 0.6 / crystal_side;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto key = key_density(seed, crystal_side);
        const vec3 reach = voxel * counts_of(key, key).reach;
        EXPECT_LT(reach.x, half.x) << seed;
        EXPECT_LT(reach.y, half.y) << seed;
        EXPECT_LT(0, half.z - hand.in_front) << seed;
        EXPECT_LT(reach.z - hand.in_front, half.z) << seed;
    }
}

TEST(CrystalShape, AKeyHasARingWithAHoleAShaftAndBits) {
    const auto at = [](const std::vector<float>& density, vec3 place) {
        const vec3 v = glm::round(place + 0.5 * (side - 1));
        return density[static_cast<std::size_t>(v.x) +
                       side * (static_cast<std::size_t>(v.y) + side * static_cast<std::size_t>(v.z))];
    };
    std::set<std::size_t> volumes;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const auto shape = key_shape(seed);
        const auto key = key_density(seed, crystal_side);
        EXPECT_EQ(at(key, {shape.ring_x, 0, 0}), 0) << "the ring's hole, seed " << seed;
        EXPECT_GE(at(key, {shape.ring_x - shape.ring_radius, 0, 0}), solid) << seed;
        EXPECT_GE(at(key, {shape.ring_x, shape.ring_radius * shape.ring_high, 0}), solid) << seed;
        EXPECT_GE(at(key, {shape.shaft_end - 3, 0, 0}), solid) << seed;
        ASSERT_GE(shape.bit_count, 2U);
        for (std::size_t i = 0; i < shape.bit_count; ++i) {
            const auto& bit = shape.bits[i];
            EXPECT_GE(at(key, {bit.along, shape.side * (bit.deep - 1.2), 0}), solid) << seed;
            EXPECT_LT(at(key, {bit.along, -shape.side * (shape.shaft_thick + 2), 0}), solid) << seed;
        }
        volumes.insert(counts_of(key, key).key);
    }
    EXPECT_GT(volumes.size(), 40U) << "keys differ by seed";
}

TEST(CrystalShape, ASeedGivesTheSameBitsAgain) {
    const auto key = key_density(5, crystal_side);
    EXPECT_EQ(key, key_density(5, crystal_side));
    EXPECT_EQ(rough_density(5, key, crystal_side), rough_density(5, key, crystal_side));
    EXPECT_NE(key, key_density(6, crystal_side));
}

}  // namespace
}  // namespace thaum::game::test
