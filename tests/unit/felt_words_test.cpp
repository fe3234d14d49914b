// Tests of the captions for sounds and effects: every source has a caption with its side, and none is shown
// twice.
#include "game/senses/felt_words.h"

#include <set>

#include "game/senses/senses.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

const std::shared_ptr<const SenseData>& sense_data() {
    static const auto loaded = [] { return SenseData::load(assets(), audio::WithSamples::no).value(); }();
    return loaded;
}

/// A match whose first player's sounds and effects the test triggers.
struct WordsRig {
    explicit WordsRig(std::shared_ptr<const SenseData> data = sense_data())
        : match(duel_data(), two_hands()),
          senses(Senses::create(std::move(data), *match.data().presentation)) {
        senses->follow(match);
        play(ticks(2));  // long enough for the captions of the start to disappear
    }

    void play(Tick count) {
        for (Tick t = 0; t < count; ++t) {
            match.tick({});
            senses->follow(match);
        }
    }
    vec3 middle() const { return match.world().get<Motion>(wizard_of(match.world(), 0)).position; }
    void turn(double yaw) { match.world_to_change().get<Gaze>(wizard_of(match.world(), 0)).yaw = yaw; }
    void place_other(vec3 at) {
        match.world_to_change().get<Motion>(wizard_of(match.world(), 1)).position = at;
    }
    void happen(EventKind kind, vec3 from, std::uint32_t by = no_player) {
        record(match.context_to_change(), {.tick = match.match().played,
                                           .kind = kind,
                                           .subject = 0,
                                           .by = by,
                                           .amount = 20,
                                           .place = from});
        play(audio::frame_ticks);
    }
    /// All captions of the first player except those of the music.
    std::vector<std::string> lines() const {
        std::vector<std::string> out;
        for (const auto& line : senses->lines(0)) {
            const auto words = words_of(line);
            if (words.find("music") == std::string::npos) out.push_back(words);
        }
        return out;
    }
    HandState& hand() { return match.world_to_change().get<HandState>(wizard_of(match.world(), 0)); }

    Simulation match;
    std::unique_ptr<Senses> senses;
};

// ---- captions of all sources -----------------------------------------------------------------------------

/// One thing that is heard or felt, and its caption.
struct Source {
    std::string name;
    std::string words;
};

/// Everything that has a caption: sounds and effects of all events, of all wands and of the match's state,
/// and all forces on the hand.
std::vector<Source> all_sources(const Presentation& shown, const MatchSounds& sounds,
                                const MatchEffects& effects) {
    std::vector<Source> all;
    const auto& bank = sense_data()->bank;
    const auto hear = [&](std::string name, const SoundNumber& number) {
        if (number) all.push_back({std::move(name), bank.sounds[*number].caption});
    };
    const auto feel = [&](std::string name, std::uint32_t number) {
        all.push_back({std::move(name), sense_data()->effects.effects[number].caption});
    };
    for (std::size_t kind = 0; kind < shown.events.size(); ++kind) {
        const auto name = std::string(name_of(static_cast<EventKind>(kind)));
        hear("sound of " + name, sounds.events[kind]);
        if (effects.events[kind]) feel("effect of " + name, *effects.events[kind]);
    }
    for (const auto& number : sounds.power_ups) hear("power-up", number);
    for (std::size_t i = 0; i < cues; ++i) hear(std::string(cue_names.at(i)), sounds.cues.at(i));
    for (const auto& wand : sounds.wands)
        for (const auto& number : {wand.fire, wand.burst, wand.take, wand.ready, wand.hold})
            hear("wand", number);
    for (const auto number : {effects.recoil, effects.stir, effects.heartbeat, effects.great_work,
                              effects.walk_left, effects.walk_right})
        feel("state", number.value());
    for (const auto& force : force_words) all.push_back({"force", std::string(force.verb)});
    return all;
}

TEST(FeltWords, CaptionsCoverEveryEvent) {
    const auto data = duel_data();
    const auto& shown = *data->presentation;
    const auto sounds = match_sounds(sense_data()->bank, shown);
    const auto effects = match_effects(sense_data()->effects, shown);
    const auto sources = all_sources(shown, sounds, effects);
    EXPECT_GT(sources.size(), 70U);
    for (const auto& source : sources) EXPECT_FALSE(source.words.empty()) << source.name << " has no words";
    for (const auto& row : shown.events) {
        const bool marked = row.mark == HudMark::hit || row.mark == HudMark::fall;
        EXPECT_TRUE(!marked || !row.tactile.empty()) << "a hurt without an effect";
    }
    for (const auto& wand : data->wands) EXPECT_FALSE(wand.look.steady_force.empty());
}

/// Whether the first player gets a caption, in words on the screen, for an event that happens 3 m away.
bool is_told(const std::shared_ptr<const SenseData>& data, EventKind kind) {
    WordsRig rig(data);
    rig.happen(kind, rig.middle() + vec3(0, 0, 3));
    return !rig.lines().empty();
}

TEST(FeltWords, EachEventWithASoundOrAnEffectIsToldWhenItHappens) {
    const auto data = duel_data();
    const auto& rows = data->presentation->events;
    auto deaf = std::make_shared<SenseData>(*sense_data());
    for (auto& sound : deaf->bank.sounds) sound.caption.clear();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto kind = static_cast<EventKind>(i);
        EXPECT_TRUE(rows[i].sound.empty() || is_told(sense_data(), kind)) << name_of(kind);
        // If sounds have no captions, those of effects are shown instead.
        EXPECT_TRUE(rows[i].tactile.empty() || is_told(deaf, kind)) << name_of(kind);
    }
}

// ---- captions of hits on the player ----------------------------------------------------------------------

TEST(FeltWords, TheOwnHitHasItsSideAndIsToldOnce) {
    constexpr std::array<std::pair<vec3, const char*>, 4> places{{{{0, 0, -3}, "hit from ahead"},
                                                                  {{0, 0, 3}, "hit from behind"},
                                                                  {{3, 0, 0}, "hit from the right"},
                                                                  {{-3, 0, 0}, "hit from the left"}}};
    for (const auto& [from, words] : places) {
        WordsRig rig;
        rig.turn(0);
        rig.happen(hit_kind("bolt_hit"), rig.middle() + from);
        EXPECT_EQ(rig.lines(), std::vector<std::string>{words});
    }
}

TEST(FeltWords, AHitComesFromTheShooterWhereverOnTheBodyItStrikes) {
    WordsRig rig;
    rig.turn(0);
    rig.place_other(rig.middle() + vec3(0, 0, -8));
    rig.happen(hit_kind("bolt_hit"), rig.middle() + vec3(0.3, 0, 0.05), 1);
    EXPECT_EQ(rig.lines(), std::vector<std::string>{"hit from ahead"}) << "it struck the right flank";
    WordsRig behind;
    behind.turn(0);
    behind.place_other(behind.middle() + vec3(0, 0, -8));
    behind.happen(hit_kind("blast_hit"), behind.middle() + vec3(0, 0, 2), 1);
    EXPECT_EQ(behind.lines(), std::vector<std::string>{"hard hit from behind"}) << "a burst behind the back";
}

TEST(FeltWords, AFallAndAHitFromNowhereHaveNoSide) {
    WordsRig rig;
    rig.happen(EventKind::fall, rig.middle() + vec3(4, -5, 0));
    EXPECT_EQ(rig.lines(), std::vector<std::string>{"fall"});
    WordsRig other;
    other.happen(hit_kind("bolt_hit"), other.middle());
    EXPECT_EQ(other.lines(), std::vector<std::string>{"hit"});
}

TEST(FeltWords, WithoutASoundTheEffectTellsTheSide) {
    auto poor = std::make_shared<SenseData>(*sense_data());
    poor->bank.sounds[*poor->bank.find("hit_wizard")].caption.clear();
    WordsRig rig(poor);
    rig.turn(0);
    rig.happen(hit_kind("bolt_hit"), rig.middle() + vec3(0, 0, 3));
    EXPECT_EQ(rig.lines(), std::vector<std::string>{"bolt strikes from behind"});
}

// ---- captions of forces ----------------------------------------------------------------------------------

TEST(FeltWords, EachForceOnTheHandIsToldWithItsDirection) {
    WordsRig rig;
    HeardLines lines;
    HandWords words;
    const auto told = [&](auto set) {
        lines = {};
        words = {};
        rig.hand() = {};
        set(rig.hand());
        words.take(rig.match, 0, lines);
        return lines.lines().empty() ? std::string() : words_of(lines.lines()[0]);
    };
    EXPECT_EQ(told([](HandState&) {}), "");
    EXPECT_EQ(told([](HandState& h) {
                  h.servo.pulses[0] = {.peak = {0, 0, 2}, .length = 15, .at = 7};
              }),
              "wand kicks");
    EXPECT_EQ(told([](HandState& h) {
                  h.tether = {.anchor = h.device.position + vec3(0, 0, -0.01), .stiffness = 100};
              }),
              "spring pulls away");
    EXPECT_EQ(told([](HandState& h) { h.steady_force.force = {0, -1, 0}; }), "wand pulls down");
    EXPECT_EQ(told([](HandState& h) {
                  h.servo.surface.contacts = 1;
                  h.servo.surface.touched[0].force = {0, 0, 1};
              }),
              "wall pushes towards you");
    EXPECT_EQ(told([](HandState& h) { h.servo.fluid.force = {-1, 0, 0.5}; }), "brew pushes left");
    EXPECT_EQ(told([](HandState& h) { h.servo.fluid.wall = {1, 0, 0}; }), "bowl pushes right");
    EXPECT_EQ(told([](HandState& h) { h.servo.fluid.surface_force = 0.5; }), "surface of the brew pushes up");
    EXPECT_EQ(told([](HandState& h) { h.steady_force.force = {0, -0.05, 0}; }), "") << "too weak to tell";
}

TEST(FeltWords, TheSteadyForceOfAWandIsNamedByTheWand) {
    const auto data = duel_data();
    std::set<std::string> names;
    for (const auto& wand : data->wands) names.insert(wand.look.steady_force);
    EXPECT_EQ(names.count("Weight"), 1U);
    EXPECT_EQ(names.count("Charge"), 1U);
    EXPECT_EQ(words_of({.words = "Weight", .from = HeardFrom::below, .verb = "pulls"}), "weight pulls down");
}

TEST(FeltWords, AForceThatTurnsIsOneLineThatChangesSideAtMostOnceASecond) {
    WordsRig rig;
    HeardLines lines;
    HandWords words;
    int changes = 0;
    HeardFrom before = HeardFrom::here;
    for (int frame = 0; frame < 500; ++frame) {  // for 4 s the force goes round, four times a second
        const double angle = 2 * pi * frame / 31.25;
        rig.play(audio::frame_ticks);
        rig.hand().servo.fluid.force = {std::cos(angle), 0, std::sin(angle)};
        lines.pass_frame();
        words.take(rig.match, 0, lines);
        ASSERT_EQ(lines.lines().size(), 1U);
        changes += lines.lines()[0].from != before ? 1 : 0;
        before = lines.lines()[0].from;
    }
    EXPECT_GE(changes, 2);
    EXPECT_LE(changes, 5);
    for (int frame = 0; frame < 201; ++frame) lines.pass_frame();
    EXPECT_EQ(lines.lines().size(), 0U);
}

TEST(FeltWords, AShotIsToldByItsSoundAndItsKickOnceEach) {
    WordsRig rig;
    input::InputFrame frame;
    frame.devices[0].press(input::Button::fire);
    frame.devices[0].counts[input::hand::trigger] = 255;
    for (int t = 0; t < 200; ++t) {
        rig.match.tick(frame);
        rig.senses->follow(rig.match);
    }
    std::multiset<std::string> told;
    for (const auto& line : rig.lines()) told.insert(line);
    EXPECT_EQ(told.count("wand kicks"), 1U);
    EXPECT_EQ(told.size(), 2U) << "and the bolt";
}

TEST(FeltWords, ThePlayersWishDecidesOnAllOfThem) {
    const HeardLine force{.words = "Weight", .from = HeardFrom::below, .verb = "pulls"};
    const HeardLine hit{.words = "hit", .from = HeardFrom::behind, .important = true};
    EXPECT_FALSE(wants(HeardWish::none, hit));
    EXPECT_TRUE(wants(HeardWish::important, hit));
    EXPECT_FALSE(wants(HeardWish::important, force));
    EXPECT_TRUE(wants(HeardWish::all, force));
}

}  // namespace
}  // namespace thaum::game::test
