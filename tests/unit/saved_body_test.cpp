// Tests of saving a carved body of the volume lab to files, and of volumes whose positions relative to each
// other are those in their files.
#include "game/lab/saved_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/file.h"
#include "field/analytic.h"
#include "field/nrrd.h"
#include "field/volume_file.h"
#include "game/lab/hand_path.h"
#include "game/lab/volume_lab.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

namespace fs = std::filesystem;

VolumeLab opened(field::Volume volume) {
    return make_volume_lab(std::move(volume),
                           load_volume_lab_data(fs::path(THAUM_SOURCE_DIR) / "assets", "premium").value())
        .value();
}

VolumeLab made_body(int count) { return opened(*field::make_volume("sphere", count, 3)); }

/// Holds a tool at the top of the generated ball for 0.2 s.
void hold_tool(VolumeLab& lab, std::string_view tool) {
    const vec3 top(0, 0.4 * field::made_extent * lab.placement.scale, 0);
    lab.hand = haptics::resting_at(top);
    const auto at = std::ranges::find(lab.data.tools, tool, &field::Tool::name);
    for (int i = 0; i < 200; ++i)
        step_volume_lab(
            lab,
            {.target = top, .carve = true, .tool = static_cast<std::size_t>(at - lab.data.tools.begin())});
    step_volume_lab(lab, {.target = top});
}

TEST(SavedBody, ColoursAndMaterialsComeBackWithTheDensities) {
    TemporaryFolder folder;
    const auto file = folder.path() / "body.nrrd";
    auto lab = made_body(24);
    ASSERT_TRUE(save_volume(lab, file));
    EXPECT_FALSE(fs::exists(folder.path() / "body.colour.nrrd")) << "nothing was painted";
    for (const char* tool : {"paint", "squirt", "melt"}) hold_tool(lab, tool);
    ASSERT_TRUE(save_volume(lab, file));
    auto again = opened(*field::read_volume(file));
    const auto taken = take_saved_properties(again, file);
    ASSERT_TRUE(taken) << taken.error().message;
    EXPECT_EQ(again.body.density, lab.body.density);
    EXPECT_EQ(again.body.colour, lab.body.colour);
    EXPECT_EQ(again.body.material, lab.body.material);
    EXPECT_TRUE(std::ranges::any_of(lab.body.material, [](auto m) { return m != 0; }));
    auto other = made_body(16);
    EXPECT_FALSE(take_saved_properties(other, file)) << "they belong to a body of another size";
}

TEST(SavedBody, PartsOfTwoBodiesAreNotTakenForOne) {
    TemporaryFolder folder;
    const auto file = folder.path() / "body.nrrd", colours = folder.path() / "body.colour.nrrd";
    auto lab = made_body(24);
    hold_tool(lab, "paint");
    ASSERT_TRUE(save_volume(lab, file));
    const auto older = read_file(colours, 1'000'000).value();
    hold_tool(lab, "melt");
    hold_tool(lab, "paint");
    ASSERT_TRUE(save_volume(lab, file));
    ASSERT_TRUE(write_file(colours, older));  // as if the power had failed before the colours were put there
    auto again = opened(*field::read_volume(file));
    const auto message = message_of(take_saved_properties(again, file));
    EXPECT_NE(message.find("body.colour.nrrd: belongs to another body"), std::string::npos) << message;
}

TEST(SavedBody, NothingIsReplacedIfOnePartCannotBeWritten) {
    TemporaryFolder folder;
    const auto file = folder.path() / "body.nrrd";
    auto lab = made_body(24);
    ASSERT_TRUE(save_volume(lab, file));
    const auto before = read_file(file, 1'000'000).value();
    hold_tool(lab, "paint");
    fs::create_directory(folder.path() / "body.colour.nrrd");
    EXPECT_FALSE(save_volume(lab, file));
    EXPECT_EQ(read_file(file, 1'000'000).value_or(Bytes{}), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2)
        << "no half-written file is left";
}

TEST(SavedBody, AMedicalScanKeepsThePatientsFrame) {
    TemporaryFolder folder;
    const auto file = folder.path() / "scan.nrrd";
    auto scan = *field::make_volume("sphere", 16, 1);
    scan.is_of_patient = true;
    scan.placement.origin = {0.1, 0.2, 0.3};
    ASSERT_TRUE(field::write_nrrd(file, scan));
    auto lab = opened(*field::read_volume(file));
    hold_tool(lab, "paint");
    ASSERT_TRUE(save_volume(lab, folder.path() / "again.nrrd"));
    for (const char* name : {"again.nrrd", "again.colour.nrrd"}) {
        const auto again = field::read_volume(folder.path() / name).value();
        EXPECT_TRUE(again.is_of_patient) << name;
        EXPECT_EQ(again.placement.origin, lab.source.placement.origin) << name;
    }
    EXPECT_EQ(opened(*field::read_volume(folder.path() / "again.nrrd")).placement.turn, lab.placement.turn);
}

/// A ball about the origin of the file's frame, in a box of `half` around `middle` (m).
field::Volume ball_in_box(vec3 middle, double half) {
    const field::Sphere ball{.middle = -middle, .radius = 0.05};
    auto volume = field::sampled(field::field_of<field::Scalar>(ball), {33, 33, 33}, vec3(half / 16));
    volume.placement.origin = middle;
    volume.has_place = true;
    return volume;
}

TEST(RegisteredVolumes, ACropIsFeltWhereTheWholeIs) {
    auto lab = opened(ball_in_box({0, 0, 0}, 0.08));
    ASSERT_TRUE(add_volume_beside(lab, ball_in_box({0.02, 0.03, 0}, 0.04), true));
    VolumeLabSettings settings;
    settings.places = {{.origin = {0.01, 0, -0.01}, .yaw = 0.4, .scale = 0.8}};
    ASSERT_TRUE(change_volume_lab(lab, settings));
    const vec3 surface = 0.05 * glm::normalize(vec3(2, 3, 0.5));
    const auto first = volume_of(lab, 0), beside = volume_of(lab, 1);
    const vec3 in_first = field::to_parent(first.placement, surface);
    const vec3 in_beside = field::to_parent(beside.placement, surface - vec3(0.02, 0.03, 0));
    EXPECT_LE(glm::distance(in_first, in_beside), 1e-12);
    auto fitted = opened(ball_in_box({0, 0, 0}, 0.08));
    ASSERT_TRUE(add_volume_beside(fitted, ball_in_box({0.02, 0.03, 0}, 0.04)));
    EXPECT_GT(volume_of(fitted, 1).placement.scale, 1.5 * volume_of(fitted, 0).placement.scale)
        << "without registration each fills the workspace";
}

TEST(RegisteredVolumes, FilesWithoutAPlaceOrOfAnotherFrameAreRefused) {
    auto lab = opened(ball_in_box({0, 0, 0}, 0.08));
    const auto refusal = [&](const field::Volume& volume) {
        return message_of(add_volume_beside(lab, volume, true));
    };
    EXPECT_NE(refusal(*field::make_volume("sphere", 16, 1)).find("space, space directions"),
              std::string::npos);
    auto patient = ball_in_box({0, 0, 0}, 0.08);
    patient.is_of_patient = true;
    EXPECT_NE(refusal(patient).find("frame of a patient"), std::string::npos);
}

TEST(VolumeLabData, AWrongDeviceListsTheDevices) {
    for (const char* name : {"nix", "../wands/bolt"}) {
        const auto message = message_of(load_volume_lab_data(fs::path(THAUM_SOURCE_DIR) / "assets", name));
        EXPECT_NE(message.find("there are "), std::string::npos) << message;
        EXPECT_NE(message.find("premium"), std::string::npos) << message;
    }
}

TEST(HandPath, AMissingFileIsNamedWithoutWordsOfTheBrew) {
    EXPECT_EQ(message_of(hand_path("/nowhere/nix.csv")),
              "/nowhere/nix.csv: cannot open: No such file or directory");
}

}  // namespace
}  // namespace thaum::game
