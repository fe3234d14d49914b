// Tests of converting volumes to bodies of voxels and back.
#include "field/voxel_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/file.h"
#include "field/nrrd.h"
#include "unit/carving_rig.h"

namespace thaum::field {
namespace {

constexpr float nan_sample = std::numeric_limits<float>::quiet_NaN();

/// A volume of 2 x 1 x 2 samples with a placement of its own.
Volume scan(std::vector<float> samples) {
    Volume volume{.count = {2, 1, 2}, .spacing = {0.001, 0.002, 0.003}};
    volume.placement = {.origin = {1, 2, 3}, .scale = 4};
    volume.stored_as = SampleType::int16;
    volume.samples = std::move(samples);
    return volume;
}

TEST(VoxelVolume, ABodyOfIntegersHasTheDensitiesOfFloats) {
    std::vector<std::int16_t> samples;
    for (int i = 0; i < 24 * 20 * 16; ++i) samples.push_back(static_cast<std::int16_t>(i * 7919));
    Volume volume{.count = {24, 20, 16}, .spacing = vec3(0.001), .samples = samples};
    const std::vector<float> floats = volume.samples.as_floats();
    EXPECT_EQ(voxels_of(volume)->density, floats);
    auto body = voxels_of(std::move(volume)).value();
    EXPECT_EQ(body.density, floats);
    EXPECT_EQ(body.colour.size(), floats.size());
    EXPECT_EQ(body.material.size(), floats.size());
}

TEST(VoxelVolume, AScanGivesItsDensitiesAndItsFrame) {
    const auto body = voxels_of(scan({-1024, nan_sample, 40, 3071})).value();
    EXPECT_EQ(body.count, (std::array{2, 1, 2}));
    EXPECT_EQ(body.spacing, vec3(0.001, 0.002, 0.003));
    EXPECT_EQ(body.placement.origin, vec3(1, 2, 3));
    EXPECT_EQ(body.placement.scale, 4);
    EXPECT_EQ(body.empty, -1024);
    EXPECT_EQ(body.full, 3071);
    EXPECT_EQ(body.surface, 1023.5F);
    EXPECT_TRUE(std::isnan(body.density[1]));
    EXPECT_EQ(body.density[3], 3071);
    EXPECT_EQ(body.colour[0], (Rgb8{255, 255, 255}));
}

TEST(VoxelVolume, ValuesAreTheSameAtAnyPlace) {
    const Volume volume = scan({1, 2, 3, 5});
    const auto body = voxels_of(volume);
    Random random = random_stream(24, 13);
    for (int i = 0; i < 50; ++i) {
        const vec3 place = 0.002 * vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        EXPECT_EQ(body->density_grid(Kernel::linear)(place).value, volume.grid(Kernel::linear)(place).value);
    }
}

TEST(VoxelVolume, ThreeVolumesGiveTheBodyBack) {
    Voxels body = random_block({9, 10, 11}, 5);
    body.density[5] = nan_sample;
    body.density[6] = std::nextafter(1.0F, 2.0F);
    body.placement.turn = glm::mat3_cast(rotation({0, 0, 1}, 0.5));
    auto again = voxels_of(density_volume(body), DensityRange{body.empty, body.full}).value();
    ASSERT_TRUE(set_colours(again, colour_volume(body)).has_value());
    ASSERT_TRUE(set_materials(again, material_volume(body)).has_value());
    EXPECT_EQ(hash_of(again), hash_of(body));
    EXPECT_EQ(again.placement.turn, body.placement.turn);
    EXPECT_EQ(again.bricks.newest, 3U);  // both changes have raised the version, so readers see them
}

TEST(VoxelVolume, ACarvedBodyIsTheSameAfterSavingAndReading) {
    const auto scanned = voxels_of(scan({-1024, 40, 300, 3071})).value();
    Voxels body = random_block({17, 9, 12}, 8);
    body.spacing = scanned.spacing;
    body.placement = scanned.placement;
    edit(body.view(), density_filter(4, 0), {.seconds = 0.1});
    const TemporaryFolder folder;
    const auto path = [&](const char* name) { return folder.path() / name; };
    ASSERT_TRUE(write_nrrd(path("d.nrrd"), density_volume(body)).has_value());
    ASSERT_TRUE(write_nrrd(path("c.nrrd"), colour_volume(body)).has_value());
    ASSERT_TRUE(write_nrrd(path("m.nrrd"), material_volume(body)).has_value());
    auto again = voxels_of(*read_nrrd(path("d.nrrd")), DensityRange{body.empty, body.full}).value();
    ASSERT_TRUE(set_colours(again, *read_nrrd(path("c.nrrd"), {.colours_as_vectors = true})).has_value());
    ASSERT_TRUE(set_materials(again, *read_nrrd(path("m.nrrd"))).has_value());
    EXPECT_EQ(hash_of(again), hash_of(body));
}

TEST(VoxelVolume, EachVolumeIsStoredInItsType) {
    const Voxels body = random_block({4, 3, 2}, 6);
    EXPECT_EQ(density_volume(body).stored_as, SampleType::float32);
    EXPECT_EQ(colour_volume(body).stored_as, SampleType::uint8);
    EXPECT_EQ(colour_volume(body).components, 3);
    EXPECT_EQ(material_volume(body).stored_as, SampleType::uint8);
    EXPECT_EQ(material_volume(body).samples.size(), 24U);
}

TEST(VoxelVolume, AUniformScanHasARange) {
    const auto body = voxels_of(scan({7, 7, 7, 7})).value();
    EXPECT_EQ(body.empty, 7);
    EXPECT_EQ(body.full, 8);
}

TEST(VoxelVolume, WrongVolumesAreRefused) {
    const auto message = [](const Volume& volume) { return voxels_of(volume).error().message; };
    Volume vectors = scan({1, 2, 3, 4});
    vectors.components = 3;
    EXPECT_EQ(message(vectors), "only a volume of one component can be carved; this one holds vectors");
    EXPECT_EQ(message(scan({1, 2, 3})), "the volume's samples do not fit its count and spacing");
    Volume flat = scan({1, 2, 3, 4});
    flat.spacing.y = 0;
    EXPECT_EQ(message(flat), "the volume's samples do not fit its count and spacing");
    EXPECT_EQ(message({}), "the volume has too few or too many samples to be carved");
    EXPECT_EQ(voxels_of(scan({1, 2, 3, 4}), DensityRange{1, 1}).error().message,
              "the density of solid material must be above that of nothing");
}

TEST(VoxelVolume, WrongColoursAndMaterialsLeaveTheBodyAsItIs) {
    Voxels body = random_block({2, 1, 2}, 7);
    const std::uint64_t before = hash_of(body);
    EXPECT_EQ(set_materials(body, scan({0, 1, 2, 256})).error().message,
              "the volume of materials has a sample that is no whole number from 0 to 255");
    EXPECT_FALSE(set_materials(body, scan({0, 1, 2, 0.5F})).has_value());
    EXPECT_FALSE(set_materials(body, scan({0, 1, 2, nan_sample})).has_value());
    EXPECT_EQ(set_colours(body, scan({0, 1, 2, 3})).error().message,
              "the volume of colours needs 2 x 1 x 2 samples of 3 components, as the body has");
    EXPECT_EQ(hash_of(body), before);
    EXPECT_EQ(body.bricks.newest, 1U);
}

}  // namespace
}  // namespace thaum::field
