// Tests of bodies of voxels: bricks (blocks of voxels), their versions, hashes, snapshots, and the table of
// materials.
#include "field/voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/file.h"
#include "core/random.h"
#include "field/materials.h"
#include "field/voxel_state.h"

namespace thaum::field {
namespace {

/// A body with a random value in each property of each voxel; some densities are NaN.
Voxels random_body(std::array<int, 3> count, std::uint64_t seed) {
    Voxels body = make_voxels(count, vec3(0.01));
    Random random = random_stream(seed, 1);
    for (std::size_t i = 0; i < body.density.size(); ++i) {
        body.density[i] = random.below(100) == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                 : static_cast<float>(random.uniform());
        const std::uint64_t bits = random.next();
        body.colour[i] = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
                          static_cast<std::uint8_t>(bits >> 16U)};
        body.material[i] = static_cast<std::uint8_t>(bits >> 24U);
    }
    return body;
}

std::uint64_t fresh_hash(Voxels& body) {
    BrickHashes none;
    return voxel_hash(body.view(), none);
}

TEST(Voxels, EachVoxelLiesInExactlyOneBrick) {
    for (const std::array<int, 3> count :
         {std::array{1, 1, 1}, std::array{8, 16, 24}, std::array{9, 7, 17}}) {
        Voxels body = make_voxels(count, vec3(1));
        std::vector<int> times(body.density.size());
        for_each_brick(body.bricks, {{}, body.bricks.count},
                       [&](std::array<int, 3> brick, std::size_t number) {
                           ASSERT_LT(number, body.bricks.version.size());
                           const VoxelBox box = brick_box(count, brick);
                           EXPECT_EQ(bricks_around(box).low, brick);
                           for_each_row(body.view(), box, [&](std::size_t first, std::size_t) {
                               for (int i = 0; i < box.high[0] - box.low[0]; ++i)
                                   ++times[first + static_cast<std::size_t>(i)];
                           });
                       });
        EXPECT_EQ(std::ranges::count(times, 1), static_cast<std::ptrdiff_t>(times.size()));
    }
}

TEST(Voxels, TheMiddleOfAllVoxelsIsTheOrigin) {
    Voxels body = make_voxels({4, 5, 1}, {0.1, 0.2, 0.3});
    EXPECT_EQ(body.view().first_place(), vec3(-0.15000000000000002, -0.4, 0));
}

TEST(Voxels, BoxesJoinAndMeet) {
    const VoxelBox a{{0, 0, 0}, {2, 2, 2}}, b{{1, 1, 1}, {4, 3, 2}}, far{{5, 5, 5}, {6, 6, 6}};
    EXPECT_EQ(around(a, b), (VoxelBox{{0, 0, 0}, {4, 3, 2}}));
    EXPECT_EQ(around(a, {}), a);
    EXPECT_EQ(overlap(a, b), (VoxelBox{{1, 1, 1}, {2, 2, 2}}));
    EXPECT_TRUE(overlap(a, far).empty());
}

TEST(Voxels, OnlyTheBricksOfTheBoxAreMarked) {
    Voxels body = make_voxels({24, 24, 24}, vec3(1));
    mark_changed(body.bricks, {{7, 8, 0}, {9, 16, 1}});
    for_each_brick(body.bricks, {{}, body.bricks.count}, [&](std::array<int, 3> brick, std::size_t number) {
        const bool changed = brick[0] <= 1 && brick[1] == 1 && brick[2] == 0;
        EXPECT_EQ(body.bricks.version[number], changed ? 2U : 1U);
    });
    mark_changed(body.bricks, {});
    EXPECT_EQ(body.bricks.newest, 2U);
}

TEST(VoxelHash, EachBitOfEachPropertyCounts) {
    Voxels body = random_body({9, 10, 11}, 1);
    const std::uint64_t before = fresh_hash(body);
    const auto last = body.density.size() - 1;
    body.density[last] = std::nextafter(body.density[last], 2.0F);
    const std::uint64_t density = fresh_hash(body);
    body.colour[0].b ^= 1U;
    const std::uint64_t colour = fresh_hash(body);
    body.material[17] ^= 128U;
    const std::uint64_t material = fresh_hash(body);
    EXPECT_NE(before, density);
    EXPECT_NE(density, colour);
    EXPECT_NE(colour, material);
    EXPECT_NE(fresh_hash(body), before);
}

TEST(VoxelHash, BodiesOfOtherShapesHaveOtherHashes) {
    Voxels a = make_voxels({8, 16, 8}, vec3(1)), b = make_voxels({16, 8, 8}, vec3(1));
    EXPECT_NE(fresh_hash(a), fresh_hash(b));
}

TEST(VoxelHash, KeptHashesGiveTheHashOfAFullReading) {
    Voxels body = random_body({20, 17, 9}, 2);
    BrickHashes kept;
    voxel_hash(body.view(), kept);
    Random random = random_stream(2, 2);
    for (int i = 0; i < 50; ++i) {
        const auto at = static_cast<int>(random.below(17));
        const VoxelBox box{{at, at % 17, at % 9}, {at + 1, at % 17 + 1, at % 9 + 1}};
        body.density[body.view().at(box.low[0], box.low[1], box.low[2])] =
            static_cast<float>(random.uniform());
        mark_changed(body.bricks, box);
        EXPECT_EQ(voxel_hash(body.view(), kept), fresh_hash(body));
    }
}

TEST(VoxelHash, BricksWithoutANewVersionAreNotReadAgain) {
    Voxels body = random_body({16, 8, 8}, 3);
    BrickHashes kept;
    const std::uint64_t before = voxel_hash(body.view(), kept);
    // A change that does not raise the brick's version, so the hash kept for the brick is still used
    body.material[0] ^= 1U;
    EXPECT_EQ(voxel_hash(body.view(), kept), before);
    EXPECT_NE(fresh_hash(body), before);
}

TEST(VoxelSnapshot, RestoresEachBit) {
    Voxels body = random_body({17, 9, 8}, 4);
    Bytes saved;
    save(body.view(), saved);
    Voxels other = make_voxels(body.count, body.spacing);
    ByteReader reader(saved);
    ASSERT_TRUE(restore(other.view(), reader).has_value());
    EXPECT_EQ(reader.left(), 0U);
    EXPECT_EQ(fresh_hash(other), fresh_hash(body));
}

TEST(VoxelSnapshot, EqualBricksTakeNineBytes) {
    Voxels body = make_voxels({16, 16, 16}, vec3(1));
    Bytes saved;
    save(body.view(), saved);
    EXPECT_EQ(saved.size(), 12U + 8 * 9);
    body.material[0] = 1;
    saved.clear();
    save(body.view(), saved);
    EXPECT_EQ(saved.size(), 12U + 7 * 9 + 1 + 512 * 8);
}

TEST(VoxelSnapshot, OnlyBricksThatDifferGetANewVersion) {
    Voxels body = random_body({16, 16, 8}, 5);
    Bytes saved;
    save(body.view(), saved);
    body.density[body.view().at(9, 3, 0)] = 5;
    mark_changed(body.bricks, {{9, 3, 0}, {10, 4, 1}});
    BrickHashes kept;
    voxel_hash(body.view(), kept);
    ByteReader reader(saved);
    ASSERT_TRUE(restore(body.view(), reader).has_value());
    EXPECT_EQ(body.bricks.version, (std::vector<std::uint32_t>{1, 3, 1, 1}));
    EXPECT_EQ(voxel_hash(body.view(), kept), fresh_hash(body));
}

TEST(VoxelSnapshot, CutOrForeignBytesAreRefused) {
    Voxels body = random_body({9, 9, 9}, 6);
    Bytes saved;
    save(body.view(), saved);
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{11}, std::size_t{12}, std::size_t{40}, saved.size() - 1}) {
        ByteReader reader({saved.data(), size});
        EXPECT_FALSE(restore(body.view(), reader).has_value()) << size;
    }
    saved[12] = std::byte{2};  // the number of a way of packing that does not exist
    ByteReader unknown(saved);
    EXPECT_FALSE(restore(body.view(), unknown).has_value());
    Voxels other = make_voxels({9, 9, 8}, vec3(1));
    ByteReader foreign(saved);
    EXPECT_EQ(restore(other.view(), foreign).error().message, "the saved voxels are not those of this body");
}

Expected<Materials> materials_from(std::string_view toml) {
    const auto config = Config::parse(toml, "m.toml", materials_file_version);
    return config ? read_materials(*config) : config.error();
}

constexpr std::string_view skin =
    "version = 1\n[[material]]\nname = \"skin\"\nstiffness = 200\nviscosity = 2\nopacity = 0.3\n"
    "colour = [224, 172, 140]\n";

TEST(MaterialFiles, TheShippedTableHasAnInvisibleMaterialThatIsFelt) {
    const auto file = read_text_file(THAUM_SOURCE_DIR "/assets/materials.toml", 1U << 20U).value();
    const auto materials = materials_from(file).value();
    const auto index = material_index(materials, "invisible");
    ASSERT_TRUE(index.has_value());
    EXPECT_EQ(materials[*index].opacity, 0);
    EXPECT_GT(materials[*index].stiffness, 0);
    EXPECT_FALSE(material_index(materials, "nothing").has_value());
}

TEST(MaterialFiles, ReadsEachValue) {
    const auto materials = materials_from(skin).value();
    const Material& m = materials.at(0);
    EXPECT_EQ(m.name, "skin");
    EXPECT_EQ(m.stiffness, 200);
    EXPECT_EQ(m.viscosity, 2);
    EXPECT_EQ(m.opacity, 0.3);
    EXPECT_EQ(m.colour, (Rgb8{224, 172, 140}));
}

TEST(MaterialFiles, AnIndexOfAByteReachesEachMaterial) {
    std::string table = "version = 1\n";
    const auto add = [&](int i) {
        table += "[[material]]\nname = \"m" + std::to_string(i) +
                 "\"\nstiffness = 1\nviscosity = 1\nopacity = 1\ncolour = [0, 0, 0]\n";
    };
    for (int i = 0; i < 256; ++i) add(i);
    const auto materials = materials_from(table).value();
    EXPECT_EQ(material_index(materials, "m255"), 255);
    add(256);
    EXPECT_EQ(materials_from(table).error().message, "m.toml:1539: there are more than 256 materials");
}

TEST(MaterialFiles, FaultsNameTheLine) {
    const std::string once(skin);
    const std::string twice = once + once.substr(once.find('['));
    EXPECT_EQ(materials_from(twice).error().message,
              "m.toml:9: material 'skin' stands here for the second time");
    EXPECT_EQ(materials_from("version = 1\n").error().message, "m.toml:1: there is no [[material]]; add one");
    EXPECT_EQ(
        materials_from(once + "hardness = 3\n").error().message,
        "m.toml:8: unknown key 'material.hardness'; known here: colour, name, opacity, stiffness, viscosity");
    std::string part = once;
    part.replace(part.find("224"), 3, "2.5");
    EXPECT_EQ(materials_from(part).error().message, "m.toml:7: 'colour' must be three whole numbers");
    part.replace(part.find("2.5"), 3, "256");
    EXPECT_EQ(materials_from(part).error().message, "m.toml:7: 'colour' is 256, must be from 0 to 255");
}

}  // namespace
}  // namespace thaum::field
