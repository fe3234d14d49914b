// Tests of a session of the fluid lab (the cauldron's fluid alone): equal inputs give equal bits, changes of
// settings keep the flow and the amounts, a saved session continues, and invalid input is refused without any
// loss.
#include <gtest/gtest.h>

#include "core/file.h"
#include "game/data/match_data.h"
#include "game/lab/controls.h"
#include "game/lab/lab_file.h"
#include "game/lab/lab_trace.h"
#include "game/lab/script.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

const LabData& data() {
    static const LabData loaded = *load_lab_data(find_assets());
    return loaded;
}

LabSettings small() {
    LabSettings settings = lab_settings(data());
    settings.cells = 16;
    return settings;
}

LabState lab_of(const LabSettings& settings) { return make_lab(data().rules, settings).value(); }

LabScript stirred(Stirring kind) {
    return {.path = {.kind = kind},
            .pours = {{.step = 5, .substance = 1, .amount = 0.05}, {.step = 9, .amount = 0.02}}};
}

LabFigures run(LabState& lab, const LabScript& script, int steps, unsigned threads = 0,
               std::string* rows = nullptr) {
    Jobs jobs(threads);
    LabFigures figures;
    for (int i = 0; i < steps; ++i) {
        figures = step_lab(lab, scripted_input(script, lab), jobs);
        if (rows != nullptr) append_lab_row(lab, figures, false, *rows);
    }
    return figures;
}

std::vector<LabSettings> kinds() {
    LabSettings bowl = small(), box = small(), classic = small(), slippery = small();
    box.bowl = false;
    classic.solver = fluid::Solver::classic;
    classic.cells = 15;
    slippery.no_slip = false;
    slippery.order = 2;
    slippery.gravity = 1.5;
    return {bowl, box, classic, slippery};
}

TEST(Lab, ALadleMovesTheFluidAndEqualInputsGiveEqualBits) {
    for (const LabSettings& settings : kinds()) {
        LabState one = lab_of(settings), other = lab_of(settings);
        std::string rows, rows_of_other;
        const LabFigures figures = run(one, stirred(Stirring::circle), 40, 0, &rows);
        // The second lab gets the same input, but computes the fluid on another thread.
        run(other, stirred(Stirring::circle), 40, 1, &rows_of_other);
        EXPECT_GT(figures.fluid.speed, 0.1);
        EXPECT_EQ(rows, rows_of_other);
        EXPECT_EQ(save_lab(one), save_lab(other));
    }
}

TEST(Lab, TheLadleNeverDrivesTheFlowFasterThanItself) {
    LabState lab = lab_of(small());
    Jobs jobs(0);
    for (int i = 0; i < 60; ++i) {
        // The ladle jumps across the whole bowl in each step, faster than any hand.
        const LabFigures figures = step_lab(lab, {.ladle = vec3(i % 2 == 0 ? 1 : -1, -0.4, 0)}, jobs);
        // 8 m/s come from the ladle, and some more from the flow itself.
        ASSERT_LE(figures.fluid.speed, 12) << i;
    }
    const LabFigures figures = step_lab(lab, {.ladle = vec3(std::nan(""), 0, 0)}, jobs);
    EXPECT_FALSE(lab.ladle.has_value());
    EXPECT_LE(figures.fluid.speed, 12);
}

TEST(Lab, ALadleComesThroughTheSurface) {
    LabState lab = lab_of(small());
    LabScript script = stirred(Stirring::figure8);
    run(lab, script, 8);
    EXPECT_GT(energy(lab.brew.surface), 0);  // the ladle presses on the surface
    run(lab, script, 25);
    EXPECT_EQ(lab.brew.surface.inside[0], 1U);
}

TEST(Lab, EveryChangeKeepsTheFlowAndTheAmounts) {
    LabState lab = lab_of(small());
    LabFigures before = run(lab, stirred(Stirring::circle), 40);
    const auto change = [&](auto how, double energy_drift) {
        LabSettings settings = lab.settings;
        how(settings);
        const auto changed = change_lab(lab, settings);
        ASSERT_TRUE(changed.has_value()) << changed.error().message;
        const LabFigures after = figures_of(lab);
        for (std::size_t s = 0; s < 3; ++s)
            EXPECT_NEAR(after.amounts[s], before.amounts[s], 1e-6 * before.amounts[s]);
        EXPECT_NEAR(after.fluid.energy, before.fluid.energy, (energy_drift + 1e-12) * before.fluid.energy);
        before = run(lab, {}, 3);
    };
    change([](LabSettings& s) { s.viscosity = 0.1; }, 0);
    change([](LabSettings& s) { s.gravity = 0; }, 0);
    change([](LabSettings& s) { std::swap(s.substances[0].substance, s.substances[2].substance); }, 0);
    change([](LabSettings& s) { s.cells = 32; }, 0.15);
    change([](LabSettings& s) { s.cells = 15; }, 0.15);
    change([](LabSettings& s) { s.bowl = false; }, 0.15);
    change([](LabSettings& s) { s.solver = fluid::Solver::classic; }, 0.15);
    change([](LabSettings& s) { s.solver = fluid::Solver::thaum, s.bowl = true; }, 0.3);
    change([](LabSettings& s) { s.no_slip = false, s.order = 2; }, 0.15);
    EXPECT_GT(before.fluid.energy, 0);
    EXPECT_GT(lab.steps, 40);
}

TEST(Lab, InvalidInputIsRefusedAndTheOldStateStays) {
    LabState lab = lab_of(small());
    run(lab, stirred(Stirring::circle), 12);
    const Bytes before = save_lab(lab);
    const auto refused = [&](auto spoil) {
        LabSettings settings = lab.settings;
        spoil(settings);
        EXPECT_FALSE(make_lab(data().rules, settings).has_value());
        const auto changed = change_lab(lab, settings);
        EXPECT_EQ(save_lab(lab), before);
        return changed ? "" : changed.error().message;
    };
    const auto has = [](const std::string& message, const char* words) {
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    for (const int cells : {0, 1, 3, 17, 1'000'000, -16})
        has(refused([&](LabSettings& s) { s.cells = cells; }), "must be 15, 16, 24, 32, 48 or 64");
    for (const double viscosity : {-1.0, std::nan(""), 1e12})
        has(refused([&](LabSettings& s) { s.viscosity = viscosity; }), "viscosity must be");
    has(refused([](LabSettings& s) { s.substances.resize(4); }), "at most 3 substances");
    has(refused([](LabSettings& s) { s.substances[1].substance.diffusion = -1; }), "substance 2: diffusion");
    has(refused([](LabSettings& s) { s.order = 3; }), "order must be 2 or 4");
    has(refused([](LabSettings& s) { s.gravity = std::nan(""); }), "gravity");
    // A refused change in the input is reported in the values that the step returns.
    Jobs jobs(0);
    LabSettings thin = lab.settings;
    thin.viscosity = -1;
    has(step_lab(lab, {.change = thin}, jobs).refused, "viscosity must be");
    EXPECT_EQ(lab.settings.viscosity, small().viscosity);
}

TEST(Lab, AResetIsTheBeginning) {
    LabState lab = lab_of(small());
    run(lab, stirred(Stirring::circle), 12);
    Jobs jobs(0);
    step_lab(lab, {.reset = true}, jobs);
    EXPECT_EQ(lab.steps, 1);
    EXPECT_EQ(energy(lab.brew.fluid), 0);
    EXPECT_TRUE(lab.brew.fluid.state.asleep);
    EXPECT_EQ(figures_of(lab).amounts[1], 0);
}

TEST(Lab, ASavedSessionGoesOnAsIfNeverStopped) {
    const TemporaryFolder folder;
    for (const LabSettings& settings : kinds()) {
        const LabScript script = stirred(Stirring::figure8);
        LabState through = lab_of(settings);
        run(through, script, 7);
        ASSERT_TRUE(save_lab(through, folder.path() / "state").has_value());
        auto again = load_lab(folder.path() / "state", data().rules).value();
        std::string rows, rows_again;
        run(through, script, 20, 0, &rows);
        run(again, script, 20, 0, &rows_again);
        EXPECT_EQ(rows, rows_again);
        EXPECT_EQ(save_lab(through), save_lab(again));
    }
}

TEST(Lab, AFileOfAnotherBowlOrNoneIsRefused) {
    LabState lab = lab_of(small());
    const auto refusal = [&](auto spoil) {
        LabState spoilt = lab_of(small());
        spoil(spoilt);
        return message_of(restore_lab(save_lab(spoilt), data().rules));
    };
    EXPECT_EQ(refusal([](LabState&) {}), "");
    const auto has = [](const std::string& message, const char* words) {
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    has(refusal([](LabState& l) { l.settings.cells = 32; }), "grid is not that of its bowl");
    has(refusal([](LabState& l) { l.settings.cells = 17; }), "number of cells that the lab has not");
    has(refusal([](LabState& l) { l.settings.gravity = 3; }), "grid is not that of its bowl");
    has(refusal([](LabState& l) { l.settings.room.size.radius = -1; }), "no bowl can have its size");
    has(refusal([](LabState& l) { l.settings.room.filled = std::nan(""); }), "no bowl can have its size");
    has(refusal([](LabState& l) { l.settings.substances[0].name = "a\nb"; }), "no name that could be one");
    has(refusal([](LabState& l) { l.settings.substances[0].colour.x = 7; }), "a colour that is none");
    has(refusal([](LabState& l) { l.steps = -4; }), "impossible values");
    has(refusal([](LabState& l) { l.ladle = vec3(std::nan("")); }), "impossible values");
    EXPECT_FALSE(load_lab("/nowhere/at/all", data().rules).has_value());
}

TEST(LabControls, EveryKeyIsListedOnceAndChangesTheShownValue) {
    std::vector<std::string_view> keys;
    for (const LabControl& control : lab_controls()) {
        LabHands hands{.settings = small()};
        const auto shown = [&] { return control.shown(hands, data().rules); };
        const auto before = shown();
        ASSERT_TRUE(turn_control(control.more, hands, data().rules));
        EXPECT_NE(shown(), before) << control.label;
        EXPECT_TRUE(make_lab(data().rules, hands.settings).has_value()) << control.label;
        for (const auto key : {control.less, control.more}) {
            if (key.empty()) continue;
            EXPECT_EQ(std::count(keys.begin(), keys.end(), key), 0) << key;
            keys.push_back(key);
        }
    }
    LabHands hands{.settings = small()};
    EXPECT_FALSE(turn_control("Esc", hands, data().rules));
    EXPECT_FALSE(turn_control("", hands, data().rules));
}

TEST(LabControls, NoKeyGivesSettingsThatTheFluidRejects) {
    for (const LabControl& control : lab_controls()) {
        for (const auto key : {control.less, control.more}) {
            LabHands hands{.settings = small()};
            hands.settings.cells = 15;
            for (int i = 0; i < 40; ++i) turn_control(key, hands, data().rules);
            hands.settings.cells = 15;
            EXPECT_TRUE(make_lab(data().rules, hands.settings).has_value()) << control.label;
        }
    }
    LabHands none{.settings = small()};
    none.settings.substances.clear();
    for (const LabControl& control : lab_controls()) {
        turn_control(control.more, none, data().rules);
        control.shown(none, data().rules);
    }
    EXPECT_TRUE(make_lab(data().rules, none.settings).has_value());
}

TEST(StirPath, AFileIsFollowedAndItsFaultsAreNamed) {
    const auto path = parse_stir_path("time_s,x_m,y_m,z_m\n1,0,-0.2,0\r\n2,1,-0.4,0.5\n", "f").value();
    const Basin basin{};
    EXPECT_FALSE(ladle_at(path, basin, 0.9).has_value());
    EXPECT_EQ(*ladle_at(path, basin, 1), vec3(0, -0.2, 0));
    EXPECT_NEAR(glm::length(*ladle_at(path, basin, 1.5) - vec3(0.5, -0.3, 0.25)), 0, 1e-15);
    EXPECT_FALSE(ladle_at(path, basin, 2.1).has_value());
    const auto fault = [](std::string_view csv) { return message_of(parse_stir_path(csv, "f")); };
    EXPECT_EQ(fault("1,2,3\n"), "f:1: the number of cells is 3, that of titles 4");
    EXPECT_EQ(fault("1,2,3,x\n"), "f:1: 'x' in the column 'z_m' is not a finite number");
    EXPECT_EQ(fault("1,0,0,0\n1,0,0,0\n"), "f:2: times must rise");
    EXPECT_NE(fault("-1,0,0,0\n").find("f:1: times are"), std::string::npos);
    EXPECT_NE(fault("1,101,0,0\n").find("f:1: times are"), std::string::npos);
    EXPECT_EQ(fault("1,inf,0,0\n"), "f:1: 'inf' in the column 'x_m' is not a finite number");
    EXPECT_EQ(fault("time_s,x_m,y_m,z_m\n"), "f:1: no places in it");
    EXPECT_EQ(fault(""), "f:1: the file is empty");
    EXPECT_FALSE(stir_path("square").has_value());
}

}  // namespace
}  // namespace thaum::game
