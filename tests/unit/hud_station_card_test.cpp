// Tests of the cards (panels of text) at the orb and at a crystal: all texts are readable, and none overlap.
#include "game/hud/station_card.h"

#include <algorithm>
#include <vector>

#include "game/components/crystal.h"
#include "game/components/orb.h"
#include "game/components/station.h"
#include "game/data/control_names.h"
#include "game/hud/layout.h"
#include "game/hud/prompts.h"
#include "render/font.h"
#include "unit/hud_busy.h"
#include "unit/hud_words.h"

namespace thaum::game::hud_tests {
namespace {

HudSettings with_keys(HudSettings settings) {
    for (auto& one : settings.controls) one.wands = {"1", "2", "3", "4", "5", "6"};
    return settings;
}

/// Many other texts beside the card: a potion, both halves of the Great Work (a goal of the match), a kill
/// feed, captions of sounds.
Picture busy() {
    auto picture = picture_of(*new_match());
    for (auto& p : picture.wizards) {
        p.vitals.giver_names[0] = "haste";
        p.vitals.giver_left_s[0] = 12.4;
        p.vitals.givers = 1;
        p.casting.there = true;
        p.casting.focus = 72.3;
        p.casting.focus_cap = 100;
        p.senses.heard_lines = static_cast<std::uint32_t>(p.senses.heard.size());
        p.senses.heard.fill(
            {.words = "orb hums", .from = HeardFrom::ahead, .important = true, .verb = "pulls"});
    }
    picture.wizards[0].stations.work.left_s = 22.4;
    picture.feed_lines = static_cast<std::uint32_t>(picture.feed.size());
    for (auto& line : picture.feed) line.event = {.kind = EventKind::work_half, .subject = 0, .by = 0};
    return picture;
}

enum class At { orb, orb_core, orb_told, orb_near, crystal, crystal_near };
constexpr std::array all_places{At::orb,      At::orb_core, At::orb_told,
                                At::orb_near, At::crystal,  At::crystal_near};

ScryingPicture scrying_at(At place) {
    ScryingPicture orb;
    orb.near = orb.faces = true;
    orb.scries = place != At::orb_near;
    orb.modes = {"viscosity", "gradient", "force", "follow", "vortex tube", "surface"};
    orb.worn[3] = orb.worn[4] = true;
    orb.newest = 4;
    orb.curve.fill(0.5F);
    orb.wanted_s = 1.5;
    orb.core_near = place == At::orb_core;
    orb.held_s = orb.core_near ? 0.8 : 0;
    orb.told = place == At::orb_told;
    orb.potion = "azoth";
    if (orb.told) orb.order = {"moss", "salt", "mist"};
    return orb;
}

CarvingPicture carving_at(At place) {
    CarvingPicture crystal;
    crystal.near = crystal.faces = true;
    crystal.carves = place == At::crystal;
    crystal.tools = {"melt", "construct", "paint", "stamp"};
    crystal.tool = 1;
    crystal.overlap = 0.574;
    crystal.wanted = 0.8;
    return crystal;
}

Picture busy_at(At place) {
    auto picture = busy();
    for (auto& p : picture.wizards) {
        if (place == At::crystal || place == At::crystal_near)
            p.stations.carving = carving_at(place);
        else
            p.stations.scrying = scrying_at(place);
    }
    return picture;
}

TEST(StationCard, EveryLineThatAPlayerNeedsIsReadableInEveryView) {
    const std::array<std::vector<std::string_view>, all_places.size()> needed{
        {{"Find the core", "1.5 s", "Follow and vortex tube", "Haste 13 s", "viscosity", "surface"},
         {"At the core: stay", "0.8 of", "Haste 13 s"},
         {"Azoth: ", "mist", "Haste 13 s"},
         {"Orb: hold [E]", "Haste 13 s"},
         {"Build where the key is pale", "Left mouse", "57 % of 80 %", "Haste 13 s", "construct"},
         {"Crystal: hold [E]", "57 % of 80 %", "Haste 13 s"}}};
    for (std::size_t i = 0; i < needed.size(); ++i) {
        const auto picture = busy_at(all_places.at(i));
        each_view([&](const HudSettings& settings, const std::string& name) {
            const auto overlay = overlay_of(picture, with_keys(settings));
            const std::size_t views = settings.watch == Watch::both ? 2 : 1;
            for (const auto part : needed.at(i)) {
                const auto found = find_words(overlay, part);
                EXPECT_GE(found.number, 2 * views) << name << ": " << part << " (each with its shadow)";
                EXPECT_GE(found.least, readable) << name << ": " << part;
            }
        });
    }
}

TEST(StationCard, SaysWhetherTheToolHelpsAndHowToTurn) {
    auto picture = busy_at(At::crystal);
    auto settings = with_keys({});
    for (auto& controls : settings.controls) controls.aside = "A D";
    EXPECT_TRUE(card_of(picture, settings, 0).brew.ends_with("turn it: [A D]"));
    const std::array words{"nothing here", "good place", "spoils the key"};
    for (const auto worth : {DabWorth::nothing, DabWorth::helps, DabWorth::spoils}) {
        picture.wizards[0].stations.carving.tip.worth = worth;
        const auto step = card_of(picture, settings, 0).step;
        EXPECT_NE(step.find(words.at(static_cast<std::size_t>(worth))), step.npos) << step;
    }
    picture.wizards[0].stations.carving.overlap = 0;
    EXPECT_TRUE(card_of(picture, settings, 0).brew.starts_with("Untouched; carve 80 % of the key"));
}

TEST(StationCard, IsGoneWhileItsPlayerLooksAway) {
    for (const auto place : {At::orb_near, At::crystal_near}) {
        auto p = busy_at(place).wizards[0];
        EXPECT_TRUE(has_card(p));
        p.stations.scrying.faces = p.stations.carving.faces = false;
        EXPECT_FALSE(has_card(p));
        const auto prompt = prompt_of(p, with_keys({}).controls[0]);
        EXPECT_FALSE(prompt && (prompt->kind == PromptKind::scry || prompt->kind == PromptKind::carve));
    }
    auto works = busy_at(At::crystal).wizards[0];
    works.stations.carving.faces = false;
    EXPECT_TRUE(has_card(works)) << "a hand at work";
}

TEST(StationCard, NoTwoTextsOverlapAtTheBusiestMoment) {
    auto font = render::Font::load();
    if (!font) GTEST_SKIP() << font.error().message;
    for (const auto place : all_places) {
        auto picture = busy_at(place);
        for (auto& p : picture.wizards) {
            p.stations.work_half = p.stations.work.lens = true;
            p.senses.force.source = "vortex tube";
            p.senses.force.cap = 1;
            p.senses.force.current = vec3(0.5);
        }
        each_view([&](const HudSettings& settings, const std::string& name) {
            for (const render::Size window : {render::Size{1280, 720}, {1920, 1080}, {800, 600}}) {
                const auto words = words_of(overlay_of(picture, with_keys(settings), window), *font);
                EXPECT_GT(words.size(), 8U);
                expect_apart(words, text(name, ", ", window.width, ", place ", static_cast<int>(place)));
            }
        });
    }
}

TEST(StationCard, BothPlayersReadTheSecondsOfTheGreatWork) {
    auto picture = busy();
    each_view([&](const HudSettings& settings, const std::string& name) {
        const auto overlay = overlay_of(picture, settings);
        for (const std::string_view part : {"23 s"}) {
            const auto found = find_words(overlay, part);
            EXPECT_EQ(found.number, 2U) << name << ": " << part << " (with its shadow)";
            EXPECT_GE(found.least, readable) << name << ": " << part;
        }
    });
    picture.wizards[0].stations.work.left_s = 0;
    EXPECT_FALSE(has_text(overlay_of(picture, {}), "Great Work of")) << "nobody holds it";
}

TEST(StationCard, TellsAPadHowItGoesOn) {
    const auto picture = busy_at(At::orb);
    HudSettings settings;
    settings.controls[0].next_wand = "RB";
    EXPECT_NE(card_of(picture, settings, 0).brew.find("others: [RB]"), std::string::npos);
    EXPECT_NE(card_of(picture, with_keys(settings), 0).brew.find("[1] to [6]"), std::string::npos);
}

TEST(StationCard, OffersToScryAndToCarve) {
    const ControlNames controls{.fire = "Left mouse", .stir = "E", .trace = "Right mouse"};
    const auto at = [&](At place) { return prompt_of(busy_at(place).wizards[0], controls); };
    EXPECT_EQ(at(At::orb_near)->words, "[E] Scry");
    EXPECT_EQ(at(At::orb)->words, "[Right mouse] Draw the strength of vortex tube");
    EXPECT_EQ(at(At::crystal_near)->words, "[E] Carve");
    EXPECT_FALSE(at(At::orb_told)) << "nothing more to find out";
    EXPECT_FALSE(at(At::crystal));
}

TEST(StationStrip, MarksWhatIsWornAndWhatIsInHandInPlaceOfTheWands) {
    const auto plates = [](const render::Overlay& overlay) {
        return std::ranges::count(items_of<render::RectItem>(overlay), render::colour(0x6A4A9A, 0.7F),
                                  &render::RectItem::colour);
    };
    HudSettings one_view;
    one_view.watch = Watch::first;
    EXPECT_EQ(plates(overlay_of(busy_at(At::orb), one_view)), 2) << "two modes are worn";
    EXPECT_EQ(plates(overlay_of(busy_at(At::crystal), one_view)), 1);
    const auto wands = overlay_of(busy_at(At::crystal_near), one_view);
    EXPECT_EQ(plates(wands), 1);
    EXPECT_FALSE(has_text(wands, "construct")) << "nobody works there yet";
}

TEST(NearView, ShowsACrystalLargeWhileItIsCarvedAndGoesBackAfterwards) {
    auto picture = busy_at(At::crystal);
    auto& p = picture.wizards[0];
    picture.crystals.assign(1, {.middle = p.vitals.eye + vec3(0, -0.4, -1.2), .edge = 0.5});
    constexpr double usual = 1.2, aspect = 2;
    NearView view;
    const double nearest = field_of_player(picture, 0, usual, aspect, view);
    EXPECT_NEAR(std::tan(nearest / 2) * std::hypot(0.4, 1.2) / 0.5, 0.5, 1e-9)
        << "a first picture does not wait";
    NearView tall;
    EXPECT_NEAR(std::tan(field_of_player(picture, 0, 2.4, 0.5, tall) / 2), 2 * std::tan(nearest / 2), 1e-9)
        << "in a tall view the crystal fills the width";
    p.stations.carving = {};
    double last = nearest;
    for (int i = 0; i < 35; ++i) {
        picture.tick += 10;
        const double current = field_of_player(picture, 0, usual, aspect, view);
        EXPECT_GE(current, last);
        EXPECT_LT(current - last, 0.05);
        last = current;
    }
    EXPECT_DOUBLE_EQ(last, usual);
    picture.crystals[0].edge = 5;
    p.stations.carving = carving_at(At::crystal);
    picture.tick += 5000;
    EXPECT_DOUBLE_EQ(field_of_player(picture, 0, usual, aspect, view), usual)
        << "a large crystal is not made smaller";
}

/// Number of gold arcs in a box.
std::size_t gold_in(const render::Overlay& overlay, const Panel& box) {
    return static_cast<std::size_t>(
        std::ranges::count_if(items_of<render::ArcItem>(overlay), [&](const auto* arc) {
            return arc->colour == render::colour(0xFFD060, 1.0F) &&
                   glm::all(glm::greaterThanEqual(arc->centre - arc->outer, box.low)) &&
                   glm::all(glm::lessThanEqual(arc->centre + arc->outer, box.high));
        }));
}

TEST(StationCard, HalvesOfTheGreatWorkAreInTheBoxOfTheHealth) {
    auto picture = picture_of(*new_match());
    const HudSettings settings;
    const auto box = lay_out(settings, {1280, 720}, picture.shown->wands.size()).views[0]->health;
    const auto gold = [&] { return gold_in(overlay_of(picture, settings), box); };
    EXPECT_EQ(gold(), 0U);
    picture.wizards[0].stations.work_half = true;
    EXPECT_EQ(gold(), 2U) << "half a disc and its rim";
    picture.wizards[0].stations.work.lens = true;
    EXPECT_EQ(gold(), 4U);
}

// ---- what the cards show of a match ----------------------------------------------------------------------

TEST(StationPicture, TellsWhatAWizardDoesAtTheOrb) {
    auto match = new_match();
    auto& world = match->world_to_change();
    const auto wizard = wizard_of(world, 0);
    const Orb orb = world.single<Orb>();
    EXPECT_FALSE(picture_of(*match).wizards[0].stations.scrying.near);
    world.get<Motion>(wizard).position = orb.middle + vec3(1.4, 0, 0);
    world.get<WornModes>(wizard).worn = {2, 4};
    auto picture = picture_of(*match);
    EXPECT_EQ(picture.orb.seed, orb.seed);
    const auto& scrying = picture.wizards[0].stations.scrying;
    EXPECT_TRUE(scrying.near && !scrying.scries && !scrying.told);
    EXPECT_EQ(scrying.modes[4], "vortex tube");
    EXPECT_TRUE(scrying.worn[2] && scrying.worn[4] && !scrying.worn[0]);
    EXPECT_EQ(scrying.newest, 4U);
    EXPECT_GT(scrying.curve.back(), scrying.curve.front()) << "it holds harder where the flow turns";
    EXPECT_TRUE(scrying.order[0].empty()) << "not told yet";

    world.add(wizard, AtStation{.kind = StationKind::orb});
    world.add(wizard, Scrying{.place = orb.middle + vec3(0, 0.1, 0), .force = {0, 0.5, 0}, .near_since = 1});
    world.get<WornModes>(wizard).order_told = 1;
    picture = picture_of(*match);
    EXPECT_TRUE(picture.wizards[0].stations.scrying.scries && picture.wizards[0].stations.scrying.core_near);
    EXPECT_EQ(picture.wizards[0].stations.scrying.potion, "azoth");
    EXPECT_FALSE(picture.wizards[0].stations.scrying.order[2].empty());
    ASSERT_TRUE(picture.orb.probes[0]);
    EXPECT_EQ(picture.orb.probes[0]->place, orb.middle + vec3(0, 0.1, 0));
    EXPECT_GT(picture.orb.probes[0]->force_share, 0);
    EXPECT_FALSE(picture.orb.probes[1]);
    EXPECT_FALSE(picture.orb.found[0]);
    world.get<WornModes>(wizard).told = 1;
    EXPECT_TRUE(picture_of(*match).orb.found[0]);
}

TEST(StationPicture, SharesTheVoxelsOfACrystalUntilTheyChange) {
    auto match = new_match();
    auto& world = match->world_to_change();
    auto picture = picture_of(*match);
    ASSERT_EQ(picture.crystals.size(), 2U);
    EXPECT_EQ(picture.crystals[1].voxels, nullptr) << "nobody has touched it";
    world.resize<CrystalDensity>(2 * crystal_voxels);
    world.resize<CrystalColour>(2 * crystal_voxels * sizeof(field::Rgb8));
    world.view<Crystal>().each([](Crystal& crystal) { crystal.touched = crystal.number; });
    world.blob<CrystalDensity>()[crystal_voxels + 7] = 0.75F;
    take_picture(*match, picture);
    EXPECT_EQ(picture.crystals[0].voxels, nullptr);
    const auto first = picture.crystals[1].voxels;
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->density[7], 0.75F);
    take_picture(*match, picture);
    EXPECT_EQ(picture.crystals[1].voxels, first) << "nothing was copied";
    world.blob<CrystalColour>()[(crystal_voxels + 7) * sizeof(field::Rgb8) + 1] = 9;
    take_picture(*match, picture);
    EXPECT_EQ(picture.crystals[1].voxels->colour[7].g, 9);
    EXPECT_EQ(first->colour[7].g, 0) << "an older picture stays as it was";
}

TEST(StationPicture, TellsWhatAWizardDoesAtACrystal) {
    auto match = new_match();
    auto& world = match->world_to_change();
    const auto wizard = wizard_of(world, 1);
    vec3 middle(0);
    world.view<Crystal>().each([&](Crystal& crystal) {
        crystal.overlap = 0.61;
        middle = crystal.middle;
    });
    world.get<Motion>(wizard).position = middle + vec3(1.2, 0, 0);
    EXPECT_TRUE(picture_of(*match).wizards[1].stations.carving.near);
    EXPECT_FALSE(picture_of(*match).wizards[1].stations.carving.carves);
    world.get<Lens>(wizard) = {.held = 1, .tool = 1};
    world.add(wizard, AtStation{.kind = StationKind::crystal, .number = 1});
    world.add(wizard, Chisel{.place = middle, .cutting = 1});
    world.single<GreatWork>().since[1] = 1;
    const auto p = picture_of(*match).wizards[1];
    EXPECT_TRUE(p.stations.carving.carves && p.stations.carving.tip.works && p.stations.work.lens);
    EXPECT_EQ(p.stations.carving.tools[p.stations.carving.tool], "construct");
    EXPECT_EQ(p.stations.carving.tools[3], "stamp");
    EXPECT_EQ(p.stations.carving.tools[4], "");
    EXPECT_EQ(p.stations.carving.crystal, 1U);
    EXPECT_DOUBLE_EQ(p.stations.carving.overlap, 0.61);
    EXPECT_DOUBLE_EQ(p.stations.carving.wanted, 0.8);
    EXPECT_DOUBLE_EQ(p.stations.work.left_s, 30);
}

}  // namespace
}  // namespace thaum::game::hud_tests
