// Tests of a saved session of the volume lab: its settings come back, and faults of its file are named.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <vector>

#include "core/file.h"
#include "field/analytic.h"
#include "game/lab/volume_lab.h"
#include "game/lab/volume_session.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

namespace fs = std::filesystem;

TEST(VolumeSession, SavedSettingsComeBack) {
    const auto data = load_volume_lab_data(fs::path(THAUM_SOURCE_DIR) / "assets", "premium").value();
    const auto lab = make_volume_lab(*field::make_volume("sphere", 16, 3), data).value();
    VolumeSession session{
        .first = {"a \"b\\.nrrd", 32, 9, {{0.01, 0, -0.02}, 0.5, 2}}, .device = "omni", .translucent = true};
    session.beside = {{"vortices", 16, 4, {{0, 0.03, 0}, 0, 0.5}, 3}};
    session.level = 0.1;
    session.view = SessionView{0.25, -0.5, 2.5, {0.01, 0, 0.02}};
    session.opacity = field::window(-1, 2.5, 0, 0.75);
    session.modes = {*lab_mode(lab, "isosurface"), *lab_mode(lab, "viscosity")};
    session.feel = {*feel_part("wall", std::vector{500.0, 0.8, 0.2}),
                    *feel_part("gravity", std::vector{0.0, -0.1, 0.0})};
    session.modes[0].settings.magnet = 0.3;
    session.modes[0].filters = {{field::FilterKind::smooth, 1.5}, {field::FilterKind::clamp, -1, 200}};
    session.modes[1].settings.strength =
        *field::transfer_function(std::array{vec2(0, 1), vec2(3, 0), vec2(3, 2)});
    TemporaryFolder folder;
    const auto file = folder.path() / "session.toml";
    ASSERT_TRUE(save_session(session, file));
    const auto read = load_session(file).value();
    EXPECT_EQ(session_text(read), session_text(session));
    EXPECT_EQ(read.first.volume, session.first.volume);
    ASSERT_EQ(read.beside.size(), 1U);
    EXPECT_EQ(read.beside[0].place, session.beside[0].place);
    EXPECT_EQ(read.opacity, session.opacity);
    ASSERT_TRUE(read.view);
    EXPECT_NEAR(read.view->yaw, 0.25, 1e-12);
    EXPECT_EQ(read.view->aim, session.view->aim);
    EXPECT_EQ(read.feel, session.feel);
    EXPECT_EQ(read.modes[1].settings.strength, session.modes[1].settings.strength);
}

TEST(VolumeSession, AFaultNamesItsLine) {
    const auto config =
        Config::parse("version = 1\nvolume = \"x\"\nlook = \"odd\"\nopacity = [0, 1]\n", "s.toml", 1).value();
    const auto message = message_of(read_session(config));
    EXPECT_NE(message.find("s.toml:3"), std::string::npos) << message;
}

}  // namespace
}  // namespace thaum::game
