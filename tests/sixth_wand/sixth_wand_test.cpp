// A wand that exists only in this folder (hail.cpp, hail.toml) must work like those of the game: its kinds of
// hit have numbers, names, sounds, effects and columns in statistics, bots shoot with it, and it is drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "core/file.h"
#include "core/text.h"
#include "game/bots/duel.h"
#include "game/bots/league.h"
#include "game/data/teams.h"
#include "game/live/menu_choices.h"
#include "game/match/record.h"
#include "game/match/result.h"
#include "game/match/tables.h"
#include "game/scene/figures.h"
#include "tests/sixth_wand/assets.h"
#include "unit/message_of.h"
#include "unit/overlay_items.h"

namespace thaum::game::test {
namespace {

using Data = std::shared_ptr<const MatchData>;

const std::filesystem::path& assets() {
    static const SixthWandAssets folder;
    return folder.path();
}

Data data_of(std::vector<std::string> overrides = {}) {
    return std::make_shared<const MatchData>(
        load_match_data(assets(), {.overrides = std::move(overrides)}).value());
}

/// Overridden values of data files that leave bots no other wand to shoot with.
std::vector<std::string> only_hail() {
    return {"bolt.energy.cap=0", "bolt.energy.regain_per_s=0", "blast.energy.cap=0", "lob.energy.cap=0",
            "hail.shot.damage=40"};
}

std::uint32_t slot_of_hail(const MatchData& data) {
    for (const auto& wand : data.wands) {
        if (wand.name == "hail") return wand.stats.slot;
    }
    return wand_slots;
}

TEST(EventKinds, KindsOfTheGameKeepTheirNumbersAndNewOnesFollowByName) {
    EXPECT_EQ(event_kinds().fault, "");
    EXPECT_EQ(static_cast<int>(hit_kind("bolt_hit")), 2);
    EXPECT_EQ(static_cast<int>(hit_kind("blast_hit")), 11);
    EXPECT_EQ(static_cast<int>(hit_kind("lob_hit")), 12);
    constexpr int last = static_cast<int>(EventKind::tool_taken);
    EXPECT_EQ(static_cast<int>(hit_kind("hail_frost")), last + 1);
    EXPECT_EQ(static_cast<int>(hit_kind("hail_hit")), last + 2);
    const std::vector<std::string_view> wanted{"bolt", "blast", "lob",   "blow", "fall",
                                               "brew", "venom", "frost", "hail"};
    EXPECT_EQ(std::vector(causes().begin(), causes().end()), wanted);
    EXPECT_EQ(cause_of(hit_kind("hail_hit")), 8U);
    EXPECT_EQ(cause_of(EventKind::death), max_causes);
    EXPECT_EQ(name_of(static_cast<EventKind>(1000)), "");
}

TEST(EventKinds, NumbersDoNotDependOnTheOrderOfRegistration) {
    std::vector<HitKind> hits{{.name = "a_hit", .cause = "a"},
                              {.name = "b_hit", .cause = "b", .fixed = FixedNumbers{2, 0}},
                              {.name = "c_hit", .cause = "c"},
                              {.name = "d_hit", .cause = "a"}};
    const auto first = number_event_kinds(hits);
    EXPECT_EQ(first.fault, "");
    const auto by_name = [](const HitKind& a, const HitKind& b) { return a.name < b.name; };
    while (std::next_permutation(hits.begin(), hits.end(), by_name)) {
        const auto next = number_event_kinds(hits);
        EXPECT_EQ(next.causes, first.causes);
        ASSERT_EQ(next.kinds.size(), first.kinds.size());
        for (std::size_t i = 0; i < next.kinds.size(); ++i) {
            EXPECT_EQ(next.kinds[i].name, first.kinds[i].name);
            EXPECT_EQ(next.kinds[i].cause_number, first.kinds[i].cause_number);
        }
    }
    EXPECT_EQ(first.kinds.back().name, "d_hit");
    EXPECT_EQ(first.kinds.back().cause_number,
              first.kinds[static_cast<std::size_t>(EventKind::tool_taken) + 1].cause_number)
        << "one cause for two hits";
}

TEST(EventKinds, AClashIsAFaultThatNamesBoth) {
    const auto fault = [](std::vector<HitKind> hits) { return number_event_kinds(hits).fault; };
    EXPECT_NE(fault({{.name = "death", .cause = "a"}}).find("'death' is registered twice"),
              std::string::npos);
    EXPECT_NE(fault({{.name = "a", .cause = "a", .fixed = FixedNumbers{5, 9}}}).find("'death' and 'a'"),
              std::string::npos);
    EXPECT_NE(fault({{.name = "a", .cause = "a", .fixed = FixedNumbers{30, 4}}}).find("'fall' and 'a'"),
              std::string::npos);
    std::vector<HitKind> many(20);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < many.size(); ++i) names.push_back(text("hit_", i));
    for (std::size_t i = 0; i < many.size(); ++i) many[i] = {.name = names[i], .cause = names[i]};
    EXPECT_NE(fault(many).find("at most 16 causes"), std::string::npos);
}

TEST(EventRows, EveryEventHasItsRowAndUnknownNamesAreErrorsWithTheirLine) {
    const auto data = data_of();
    ASSERT_EQ(data->presentation->events.size(), event_kinds().kinds.size());
    EXPECT_EQ(row_of(data->presentation->events, hit_kind("hail_hit")).mark, HudMark::hit);
    EXPECT_EQ(row_of(data->presentation->events, EventKind::dry).caption, "no energy");
    std::string complete;
    for (const auto& info : event_kinds().kinds) {
        const bool of_wand = info.name.ends_with("_hit") && info.name != "object_hit";
        if (!info.name.empty() && info.name != "none" && !of_wand && info.name != "hail_frost")
            complete += text("[", info.name, "]\n");
    }
    const auto fault = [](const std::string& rows) {
        const auto file = Config::parse("version = 1\n" + rows, "events.toml", 1).value();
        read_event_rows(file);
        return message_of(file.check());
    };
    EXPECT_EQ(fault(complete), "");
    EXPECT_NE(fault(complete + "[bolt_hit]\n").find("'bolt_hit' is no event of the rules"),
              std::string::npos);
    EXPECT_NE(fault("[deth]\n" + complete).find("events.toml:2"), std::string::npos);
    auto missing = complete;
    missing.erase(missing.find("[death]\n"), 8);
    EXPECT_NE(fault(missing).find("event 'death' has no row"), std::string::npos);
    EXPECT_NE(fault("[shot]\nfeed = \"{bye}\"\n").find("events.toml:3"), std::string::npos);
    EXPECT_NE(fault("[shot]\ncaption = \"{throw}\"\n").find("events.toml:3"), std::string::npos);
    EXPECT_EQ(fault(complete + "mark = \"gift\"\ncaption = \"{throw} {amount}\"\n"), "");
    EXPECT_NE(fault(complete + "mark = \"gift\"\ncaption = \"{thro}\"\n").find("controls such as {fire}"),
              std::string::npos);
    EXPECT_NE(fault("[shot]\nmark = \"cross\"\n").find("events.toml:3"), std::string::npos);
}

TEST(SixthWand, BotsShootWithItAndTheLeagueCountsItsKills) {
    auto overrides = only_hail();
    overrides.push_back("quick.kills=2");
    const std::array<std::string, 1> league{"level_3"};
    const auto match = play_league_match(assets(), data_of(overrides), league, {0, 0}, 5).value();
    const auto summary = summarise(std::array{match});
    EXPECT_GT(summary.kills[cause_of(hit_kind("hail_hit"))], 0U);
    EXPECT_EQ(summary.kills[cause_of(hit_kind("bolt_hit"))], 0U);
    const auto rows = result_rows(match.match_stats);
    const auto hail =
        std::find_if(rows.begin(), rows.end(), [](const ResultRow& row) { return row.cause == "hail"; });
    ASSERT_NE(hail, rows.end());
    EXPECT_NE((hail->words[0] + hail->words[1]).find("hit ("), std::string::npos);
}

TEST(SixthWand, BotsTakeItAmongOthersThatShootAlike) {
    auto duel = make_bot_duel(assets(), data_of({"quick.kills=1000"}), {"level_3", "level_3"}, 2).value();
    duel.run(60'000);
    const auto& match_stats = duel.match->world().single<EventLog>().match_stats;
    for (const auto* hit : {"hail_hit", "bolt_hit"}) {
        const auto cause = cause_of(hit_kind(hit));
        EXPECT_GT(match_stats[0][cause].shots + match_stats[1][cause].shots, 0U) << hit;
    }
}

TEST(SixthWand, IsNamedInFeedAndStripAndHasALookOfItsOwn) {
    const auto data = data_of();
    Simulation match(data, {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    auto& context = match.context_to_change();
    const auto victim = wizard_of(match.world(), 1);
    hurt(context, victim, 0, {.points = 5, .by = 0, .how = hit_kind("hail_frost")});
    hurt(context, victim, 0, {.points = 1000, .by = 0, .how = hit_kind("hail_hit")});
    context.world.get<WandBelt>(wizard_of(match.world(), 0)).selected = slot_of_hail(*data);
    for (int i = 0; i < 16; ++i) match.tick({});
    auto picture = make_picture();
    take_picture(match, picture);
    using hud_tests::has_text;
    const auto overlay = hud_tests::overlay_of(picture, {.split = render::Split::side_by_side});
    EXPECT_TRUE(has_text(overlay, "\u25B8 hail \u25B8")) << "the death in the feed";
    EXPECT_TRUE(has_text(overlay, "Tide feels the frost of Ember")) << "a line of the wand's own";
    EXPECT_TRUE(has_text(overlay, "Hail")) << "the wand in hand";
    const auto& wands = picture.shown->wands;
    ASSERT_EQ(wands.size(), 6U);
    EXPECT_TRUE(has_text(overlay, "6")) << "its key in the strip";
    for (const auto& wand : wands) {
        const bool same = wand_mesh(wand.look).vertices.size() == wand_mesh(wands[2].look).vertices.size();
        EXPECT_EQ(same, wand.name == "hail") << wand.name;
    }
    EXPECT_EQ(wands[2].name, "hail");
    EXPECT_FALSE(missile_mesh(wands[2].look, 0).vertices.empty());
}

TEST(SixthWand, ItsKeyIsListedInTheMenu) {
    using namespace game;
    LivePlan plan;
    plan.data = data_of();
    plan.assets = assets();
    const auto facts = find_menu_context(plan);
    auto state = opened({}, "bindings");
    const auto picture = game::picture_of(state, facts);
    const auto listed = [&](std::string_view label) {
        return std::any_of(picture.rows.begin(), picture.rows.end(),
                           [&](const MenuRow& row) { return row.label == label; });
    };
    EXPECT_TRUE(listed("Bolt"));
    EXPECT_TRUE(listed("Hail"));
    for (const auto* none : {"Wand 6", "Wand 7"}) EXPECT_FALSE(listed(none)) << "no wand has that number";
}

TEST(SixthWand, ItsKeyComesThroughARecordedLog) {
    for (std::uint8_t wand = 0; wand <= input::max_wands; ++wand) {
        input::InputFrame frame;
        frame.devices[0].wand = wand;
        Simulation match(data_of(), {1, {{.player = 0, .kind = input::DeviceKind::script, .name = "one"}}});
        for (Tick t = 0; t < 2 * gameplay_period; ++t) match.tick(frame);
        const auto selected = match.world().get<WandBelt>(wizard_of(match.world(), 0)).selected;
        EXPECT_EQ(selected, wand >= 1 && wand <= 6 ? wand - 1 : 0) << wand;
    }
}

std::uint32_t hail_hits(const Simulation& match) {
    const auto& match_stats = match.world().single<EventLog>().match_stats;
    const auto cause = cause_of(hit_kind("hail_hit"));
    return match_stats[0][cause].hits + match_stats[1][cause].hits;
}

/// Records a match of two bots whose every shot with the hail wand is a hundred lumps at once, until some
/// shots have hit. Returns the largest number of events of one tick.
std::uint64_t record_attack(const std::filesystem::path& file, std::uint32_t& hits) {
    auto overrides = only_hail();
    for (const auto* more : {"hail.shot.lumps=100", "hail.shot.per_s=1", "hail.energy.cap=100000",
                             "wizard.health.start=1000000", "wizard.health.cap=1000000"})
        overrides.emplace_back(more);
    auto duel = make_bot_duel(assets(), data_of(overrides), {"level_3", "level_3"}, 5).value();
    auto& match = *duel.match;
    auto log =
        input::LogWriter::create(file, log_header(match.data(), match.setup(), {"bot 3", "bot 3"})).value();
    std::uint64_t most = 0, before = 0;
    for (Tick t = 0; t < 60'000 && hail_hits(match) < 300; ++t) {
        tick_and_record(match, duel.next_frame(), &log);
        most = std::max(most, match.events().count() - before);
        before = match.events().count();
    }
    hits = hail_hits(match);
    EXPECT_TRUE(log.close("", {}));
    return most;
}

TEST(SixthWand, NoEventIsLostWhenAHundredHitInOneTick) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "attack.thaumlog";
    std::uint32_t recorded = 0;
    EXPECT_GE(record_attack(file, recorded), 100U) << "more than the 64 events that the World keeps";
    ASSERT_GE(recorded, 300U);
    auto playback = Playback::open(file, assets()).value();
    const auto& kinds = playback.log().header().kinds;
    ASSERT_EQ(kinds.size(), 7U);
    EXPECT_EQ(kinds[0].kinds.back(), (input::Kind{8, "hail"})) << "the last cause";
    const input::Kind hit{static_cast<std::uint16_t>(hit_kind("hail_hit")), "hail_hit"};
    EXPECT_NE(std::ranges::find(kinds[1].kinds, hit), kinds[1].kinds.end());
    EXPECT_EQ(kinds[6].kinds.back(), (input::Kind{6, "hail"})) << "the last wand";
    EventTable table;
    std::string csv;
    while (playback.step()) table.follow(playback, csv);
    EXPECT_FALSE(playback.divergence());
    std::uint32_t hits = 0;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        hits += line.find(",hail_hit,") != std::string::npos ? 1U : 0U;
        EXPECT_EQ(line.find(",lost,"), std::string::npos) << line;
    }
    EXPECT_EQ(hits, recorded);
}

TEST(EventJournal, GrowsAndKeepsEveryEventOfTheLastSeconds) {
    EventJournal journal;
    std::uint64_t seen = 0;
    std::uint32_t next = 0;
    const auto read = [&] {
        return journal.each_new(seen, [&](const Event& event) { EXPECT_EQ(event.detail, next++); });
    };
    for (std::uint32_t i = 0; i < 20'000; ++i) journal.add({.tick = 5, .detail = i});
    EXPECT_EQ(read(), 0U);
    EXPECT_EQ(next, 20'000U);
    EXPECT_EQ(journal.first(), 0U);
    for (std::uint32_t i = 0; i < 40'000; ++i)
        journal.add({.tick = 6 + EventJournal::kept, .detail = 20'000 + i});
    EXPECT_EQ(read(), 0U) << "the reader had read the old events";
    EXPECT_EQ(next, 60'000U);
    std::uint64_t late = 0;
    EXPECT_EQ(journal.each_new(late, [](const Event&) {}), journal.first());
    EXPECT_GT(journal.first(), 0U) << "old events make room";
}

TEST(EventJournal, StartsAgainWithTheEventsOfARestoredState) {
    Simulation match(data_of(), {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    for (std::uint32_t i = 0; i < 100; ++i)
        record(match.context_to_change(), {.kind = EventKind::wrested, .subject = 0, .by = 0, .detail = i});
    Bytes state;
    match.save(state);
    Simulation other(data_of(), {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    ASSERT_TRUE(other.restore(state, 0));
    EXPECT_EQ(other.events().count(), match.events().count());
    EXPECT_EQ(other.events().first(), match.events().count() - 64);
    EXPECT_EQ(other.events()[other.events().count() - 1].detail, 99U);
}

}  // namespace
}  // namespace thaum::game::test
