// Tests of the files of layouts (where the actuators are) and of effects: the shipped files are accepted, and
// the error for a faulty file names the fault.

#include <set>

#include "core/file.h"
#include "core/text.h"
#include "unit/message_of.h"
#include "unit/tactile_rig.h"

namespace thaum::tactile {
namespace {

std::string shipped(const std::string& path) {
    auto content = read_text_file(tactile_assets / path, 1U << 16U);
    EXPECT_TRUE(content.has_value()) << path;
    return content ? *content : "";
}

/// Error of a file after replacing the line that starts with `key`; empty: the file was accepted.
std::string fault_of(const std::string& path, const std::string& key, const std::string& line) {
    auto toml = shipped(path);
    const auto at = toml.find("\n" + key) + 1;
    EXPECT_NE(at, 0U) << key;
    toml.replace(at, toml.find('\n', at) - at, line);
    const auto config = Config::parse(toml, "file.toml", 1);
    if (!config) return config.error().message;
    if (path.starts_with("layouts")) {
        return message_of(read_layout(*config));
    }
    return message_of(read_effect(*config, "effect"));
}

struct Case {
    std::string path, key, line, message;
};

void expect_faults(std::initializer_list<Case> cases) {
    for (const auto& [path, key, line, message] : cases) {
        const auto fault = fault_of(path, key, line);
        EXPECT_TRUE(fault.starts_with("file.toml")) << line << ": " << fault;
        EXPECT_NE(fault.find(message), std::string::npos) << line << ": " << fault;
        EXPECT_EQ(fault.find('\n'), std::string::npos);
    }
}

TEST(TactileLayout, TheShippedOnesAreRead) {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(tactile_assets / "layouts"))
        files.insert(entry.path().stem());
    EXPECT_EQ(files, std::set<std::string>(std::begin(layout_names), std::end(layout_names)));
    EXPECT_EQ(shipped_layout("abstract_4x5").actuators.size(), 40U);
    EXPECT_EQ(shipped_layout("x40").actuators.size(), 40U);
    EXPECT_EQ(shipped_layout("x16").actuators.size(), 16U);
    EXPECT_EQ(shipped_layout("pad").actuators.size(), 2U);
    EXPECT_EQ(shipped_layout("speakers").actuators.size(), 2U);
    const auto sleeves = shipped_layout("sleeves");
    EXPECT_EQ(sleeves.actuators[19].name, "right wrist");
    EXPECT_EQ(sleeves.actuators[19].limit, 0.6);
    EXPECT_EQ(sleeves.actuators[19].lowest_hz, 80);
    EXPECT_EQ(sleeves.actuators[18].limit, 0.9);
}

TEST(TactileLayout, JacketsCountRowsFromTheTopAndFromTheWearersLeft) {
    for (const auto* name : {"abstract_4x5", "x40"}) {
        const auto layout = shipped_layout(name);
        for (std::size_t i = 0; i < 40; ++i) {
            const auto& place = layout.actuators[i].place;
            EXPECT_EQ(place.part, i < 20 ? Part::front : Part::back);
            if (i % 4 > 0) {
                EXPECT_GT(place.at.x, layout.actuators[i - 1].place.at.x);
                EXPECT_EQ(place.at.y, layout.actuators[i - 1].place.at.y);
            }
            if (i % 20 >= 4) {
                EXPECT_LT(place.at.y, layout.actuators[i - 4].place.at.y);
            }
        }
    }
}

TEST(TactileLayout, FaultsNameFileAndKey) {
    const std::string pad = "layouts/pad.toml", left = R"(    { part = "whole", name = "left)";
    expect_faults({
        {pad, "name", "name = \"\"", "'name'"},
        {pad, "lowest_hz", "lowest_hz = 0", "lowest_hz"},
        {pad, "lowest_hz", "lowest_hz = 300", "carrier range"},
        {pad, "highest_hz", "highest_hz = nan", "highest_hz"},
        {pad, "limit", "limit = 1.5", "limit"},
        {pad, "limit", "limits = 1", "limits"},
        {pad, "version", "version = 2", "version"},
        {pad, "half_width_m", "half_width_m = 0", "half_width_m"},
        {pad, left, R"({ part = "hole", at_m = [0, 1, 0] },)", "part"},
        {pad, left, R"({ part = "whole", at_m = [0, 1] },)", "at_m"},
        {pad, left, R"({ part = "whole", at_m = [0, 1e9, 0] },)", "at_m"},
        {pad, left, R"({ part = "whole", at_m = [0.15, 1.1, 0.001] },)", "one place"},
        {pad, left, R"({ part = "front", at_m = [0, 1, -0.1] },)", "z must be above 0"},
        {pad, left, R"({ part = "arm_left", at_m = [0.2, 1, 0] },)", "x must be below 0"},
        {pad, left, R"({ part = "whole", at_m = [0, 1, 0], limit = 2 },)", "limit"},
        {pad, left, R"({ part = "whole", at_m = [0, 1, 0], volume = 2 },)", "volume"},
    });
    const auto none = make_layout("none", Torso(), {});
    EXPECT_FALSE(none.has_value());
    std::vector<Actuator> many(65, Actuator{"a", {Part::whole, {}}, 50, 250, 1});
    for (std::size_t i = 0; i < many.size(); ++i) many[i].place.at.x = 0.02 * static_cast<double>(i);
    EXPECT_FALSE(make_layout("many", Torso(), many).has_value());
    many.pop_back();
    EXPECT_TRUE(make_layout("many", Torso(), many).has_value());
}

TEST(TactileEffects, TheTableOfTheJacketIsThere) {
    const auto bank = shipped_effects();
    struct Row {
        const char* name;
        double weakest, strongest, carrier, length;
    };
    for (const auto& row : {Row{"bolt_hit", 0.35, 0.35, 12, 60}, Row{"blast_hit", 0.3, 1, 18, 520},
                            Row{"lob_hit", 0.3, 1, 18, 520}, Row{"object_hit", 0.3, 1, 25, 180},
                            Row{"fall", 0.3, 1, 25, 180}, Row{"walk_left", 0.06, 0.06, 40, 50},
                            Row{"walk_right", 0.06, 0.06, 40, 50}, Row{"shield", 0.25, 0.25, 30, 400},
                            Row{"potion_ready", 0.25, 0.25, 30, 400}, Row{"orb_near", 0.25, 0.25, 30, 400},
                            Row{"heartbeat", 0.3, 0.3, 20, 3260}, Row{"great_work", 0.3, 0.3, 20, 3260}}) {
        const auto number = bank.find(row.name);
        ASSERT_TRUE(number) << row.name;
        const auto& effect = bank.effects[*number];
        EXPECT_NEAR(effect.level(0), row.weakest, 1e-12) << row.name;
        EXPECT_NEAR(effect.level(1), row.strongest, 1e-12) << row.name;
        EXPECT_NEAR(effect.carrier(), 1000 / row.carrier, 1e-9) << row.name;
        EXPECT_NEAR(effect.duration_ms(), row.length, 1e-9) << row.name;
        EXPECT_FALSE(effect.description.empty());
    }
    EXPECT_EQ(bank.effects[*bank.find("blast_hit")].speed, 0.6);
    EXPECT_EQ(bank.effects[*bank.find("heartbeat")].slowest_hz, 1.2);
    EXPECT_EQ(bank.effects[*bank.find("heartbeat")].fastest_hz, 2.4);
    EXPECT_FALSE(bank.find("nothing"));
}

TEST(TactileEffects, FaultsNameFileAndKey) {
    const std::string bolt = "effects/bolt_hit.toml", blast = "effects/blast_hit.toml",
                      heart = "effects/heartbeat.toml", fall = "effects/fall.toml";
    expect_faults({
        {bolt, "description", "description = \"\"", "'description'"},
        {bolt, "purpose", "purpose = \"fun\"", "purpose"},
        {bolt, "priority", "priority = 10", "priority"},
        {bolt, "method", "method = \"magic\"", "method"},
        {bolt, "amplitude_mm", "amplitude_mm = { weakest = 0.4, strongest = 0.3 }", "'weakest'"},
        {bolt, "amplitude_mm", "amplitude_mm = { weakest = nan, strongest = 0.3 }", "weakest"},
        {bolt, "amplitude_mm", "amplitude_mm = 0.3", "amplitude_mm"},
        {bolt, "wavelength_ms", "wavelength_ms = 0", "wavelength_ms"},
        {bolt, "wavelength_ms", "wave_ms = 12", "unknown key 'wave_ms'"},
        {bolt, "hold_ms", "hold_ms = -1", "hold_ms"},
        {bolt, "decay_ms", "decay_ms = 1e9", "decay_ms"},
        {bolt, "attack_ms", "swell_ms = 9", "unknown key 'envelope."},
        {bolt, "kind", "kind = \"burst\"", "kind"},
        {bolt, "kind", "kind = \"single\"\nspeed_m_per_s = 1", "speed_m_per_s"},
        {bolt, "kind", "kind = \"single\"\nacross_cells = 0.1", "across_cells"},
        {bolt, "kind", "kind = \"clip\"\nfile = \"../death.tact\"", "'file'"},
        {bolt, "kind", "kind = \"clip\"\nfile = \"death.toml\"", "'file'"},
        {blast, "speed_m_per_s", "speed_m_per_s = 0", "speed_m_per_s"},
        {heart, "slowest_hz", "slowest_hz = 2.9", "'slowest_hz'"},
        {fall, "places", R"(places = [{ part = "front" }])", "at_m"},
        {fall, "to", R"(to = { part = "leg", at_m = [0, 1, 0] })", "part"},
        {fall, "places",
         R"(places = [{ part = "front", at_m = [0, 1, 0.1] }, { part = "front", at_m = [0, 1, 0.1] }])",
         "one entry"},
    });
    EXPECT_FALSE(load_effects(tactile_assets / "nowhere").has_value());
    const TemporaryFolder folder;
    const auto rain = folder.path() / "rain.toml";
    ASSERT_TRUE(write_text_file(rain, "version = 1\ncolour = 3\n"));
    const auto faulty = load_effects(folder.path());
    ASSERT_TRUE(faulty);
    ASSERT_EQ(faulty->faulty.size(), 1U);
    EXPECT_EQ(faulty->faulty[0].fault.message.find(rain.string() + ":"), 0U);
}

/// Message about the only faulty effect of a folder.
std::string fault_in(const std::filesystem::path& folder) {
    const auto bank = load_effects(folder);
    return bank && bank->faulty.size() == 1 ? bank->faulty[0].fault.message : "";
}

TEST(TactileFiles, AFaultNamesTheFileWithItsFolder) {
    const TemporaryFolder folder;
    const auto layout = folder.path() / "vest.toml", effect = folder.path() / "hit.toml";
    ASSERT_TRUE(write_text_file(layout, "version = 1\n"));
    EXPECT_EQ(load_layout(layout).error().message.find(layout.string()), 0U);
    ASSERT_TRUE(write_text_file(effect, "version = 1\n"));
    std::filesystem::remove(layout);
    EXPECT_EQ(fault_in(folder.path()).find(effect.string()), 0U);
    ASSERT_TRUE(write_text_file(effect, shipped("effects/death.toml")));
    const auto clip = folder.path() / "death.tact";
    EXPECT_TRUE(fault_in(folder.path()).starts_with(text(effect.string(), ": 'file': ", clip.string())))
        << "it is missing";
    ASSERT_TRUE(write_text_file(clip, "[]"));
    EXPECT_EQ(fault_in(folder.path()).find(clip.string()), 0U) << "it is no clip";
}

}  // namespace
}  // namespace thaum::tactile
