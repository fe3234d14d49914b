// Tests of the sounds of a match: frames of sound from a duel of bots and from scripted scenes, and captions
// for people who do not hear them.
#include "game/senses/sound/sound_scene.h"

#include <map>
#include <set>

#include "audio/analysis.h"
#include "audio/mixer.h"
#include "audio/synth.h"
#include "core/hash.h"
#include "game/components/crystal.h"
#include "game/components/orb.h"
#include "game/senses/sound/heard.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

using audio::AudioFrame;
using audio::Voice;

const audio::SoundBank& bank() {
    static const audio::SoundBank loaded = [] { return audio::load_sounds(assets() / "sounds").value(); }();
    return loaded;
}

MatchSounds sounds_of(const MatchData& data) {
    auto sounds = match_sounds(bank(), *data.presentation);
    EXPECT_EQ(sounds.missing.size(), 0U) << line_of(sounds.missing[0]);
    return sounds;
}

std::uint32_t number_of(std::string_view name) { return bank().find(name).value(); }

constexpr std::array<std::uint32_t, 2> both{0, 1};

/// A match and its sounds.
struct Listening {
    explicit Listening(Simulation& simulation) : match(simulation), scene(sounds_of(simulation.data())) {}

    const AudioFrame& take() {
        scene.take(match, both, frame);
        for (const auto& voice : frame.begins) ++begun[bank().sounds[voice.sound].name];
        for (const auto& voice : frame.lasts) ++lasted[bank().sounds[voice.sound].name];
        return frame;
    }

    Simulation& match;
    SoundScene scene;
    AudioFrame frame{};
    /// By name of sound: number of voices that began, and number of frames with a lasting voice.
    std::map<std::string, int> begun{}, lasted{};
};

/// A match in which the test moves the wizards.
struct SoundRig {
    SoundRig() : match(duel_data(), two_hands()), heard(match) { heard.take(); }

    /// Plays `count` ticks with the current input of the first player.
    void play(Tick count) {
        for (Tick t = 0; t < count; ++t) {
            input::InputFrame frame;
            frame.devices[0] = device;
            match.tick(frame);
            if (match.now() % audio::frame_ticks == 0) heard.take();
        }
    }
    ecs::Entity wizard(std::uint32_t player) const { return wizard_of(match.world(), player); }

    Simulation match;
    Listening heard;
    input::DeviceSample device{};
};

// ---- sounds of a match of bots ----------------------------------------------------------------------------

/// Hash of everything in a frame of sound, combined with the hash `before`.
std::uint64_t hash_of(const AudioFrame& frame, std::uint64_t before) {
    const auto add = [&](const auto& value) { before = hash_value(value, before); };
    for (const auto* list : {&frame.begins, &frame.lasts}) {
        for (const auto& voice : *list) {
            add(voice.sound);
            add(voice.key);
            add(voice.heard_by);
            add(voice.position);
            add(voice.gain);
            add(voice.pitch);
            add(voice.muffled);
        }
    }
    add(frame.listeners);
    return before;
}

struct Played {
    std::uint64_t frames{}, state{};
    std::map<std::string, int> begun{}, lasted{};
    std::uint32_t left_out{};
    std::map<EventKind, int> events{};
};

Played play_bots(Tick count, bool listen) {
    auto duel = make_bot_duel(assets(), duel_data(), {"level_3", "level_3"}, 5).value();
    Listening heard(*duel.match);
    heard.take();
    Played out;
    std::uint64_t seen = duel.match->events().count();
    for (Tick t = 0; t < count; ++t) {
        duel.run(1);
        duel.match->events().each_new(seen, [&](const Event& event) { ++out.events[event.kind]; });
        if (!listen || duel.match->now() % audio::frame_ticks != 0) continue;
        out.frames = hash_of(heard.take(), out.frames);
        out.left_out += heard.frame.begins.left_out + heard.frame.lasts.left_out;
    }
    out.state = duel.match->state_hash();
    out.begun = heard.begun;
    out.lasted = heard.lasted;
    return out;
}

TEST(SoundScene, EqualMatchesGiveEqualFramesAndListeningChangesNothing) {
    const auto first = play_bots(ticks(20), true), second = play_bots(ticks(20), true);
    const auto deaf = play_bots(ticks(20), false);
    EXPECT_EQ(first.frames, second.frames);
    EXPECT_EQ(first.state, deaf.state);
    EXPECT_NE(first.frames, 0U);
}

TEST(SoundScene, ADuelIsHeardWhole) {
    const auto played = play_bots(ticks(60), true);
    EXPECT_EQ(played.left_out, 0U);
    const auto begun = [&](const char* name) {
        const auto found = played.begun.find(name);
        return found == played.begun.end() ? 0 : found->second;
    };
    EXPECT_GT(begun("step_stone"), 50);
    EXPECT_GT(begun("bolt_shot"), 20);
    EXPECT_EQ(begun("hit_wizard"), 2 * played.events.at(hit_kind("bolt_hit"))) << "for each player's ears";
    EXPECT_EQ(begun("death"),
              played.events.count(EventKind::death) != 0 ? played.events.at(EventKind::death) : 0);
    EXPECT_GT(played.lasted.at("music_calm"), 7000) << "of 7500 frames";
    EXPECT_GT(played.lasted.at("music_pulse"), 1000) << "the score follows the fight";
}

// ---- rows of events and their captions --------------------------------------------------------------------

TEST(SoundScene, EveryEventThatPeopleAreToldOfHasASoundWithWords) {
    const auto data = duel_data();
    const auto sounds = sounds_of(*data);
    const auto& rows = data->presentation->events;
    for (std::size_t kind = 0; kind < rows.size(); ++kind) {
        const auto name = name_of(static_cast<EventKind>(kind));
        const bool told = rows[kind].mark != HudMark::none || !rows[kind].feed.empty();
        if (!told) continue;
        EXPECT_FALSE(rows[kind].sound.empty()) << name;
        if (const auto number = sounds.events[kind]) {
            EXPECT_FALSE(bank().sounds[*number].caption.empty()) << name;
        }
    }
    for (const auto& number : sounds.power_ups) {
        ASSERT_TRUE(number);
        EXPECT_FALSE(bank().sounds[*number].caption.empty());
    }
    for (const auto number : sounds.cues) EXPECT_FALSE(bank().sounds[number.value()].caption.empty());
    for (const auto& wand : sounds.wands)
        for (const auto& number : {wand.fire, wand.burst, wand.take, wand.ready, wand.hold})
            if (number) {
                EXPECT_FALSE(bank().sounds[*number].caption.empty());
            }
}

TEST(SoundScene, EveryEffectOfTheBankIsUsedAndNoTwoSayTheSame) {
    const auto sounds = sounds_of(*duel_data());
    std::set<std::uint32_t> used;
    const auto use = [&](const SoundNumber& number) {
        if (number) used.insert(*number);
    };
    for (const auto& number : sounds.cues) use(number);
    for (const auto& number : sounds.events) use(number);
    for (const auto& number : sounds.power_ups) use(number);
    for (const auto& number : sounds.spells) use(number);
    for (const auto& wand : sounds.wands)
        for (const auto& number : {wand.fire, wand.burst, wand.take, wand.ready, wand.hold}) use(number);
    std::set<std::string> words;
    for (std::size_t i = 0; i < bank().sounds.size(); ++i) {
        const auto& sound = bank().sounds[i];
        if (sound.name.rfind("menu_", 0) == 0) continue;
        EXPECT_EQ(used.count(static_cast<std::uint32_t>(i)), 1U) << sound.name;
        EXPECT_TRUE(words.insert(sound.caption).second) << sound.caption;
    }
}

TEST(SoundScene, AMissingSoundIsNamedAndOnlyThatOneIsSilent) {
    const auto data = duel_data();
    auto poor = bank();
    poor.sounds.erase(poor.sounds.begin() + static_cast<std::ptrdiff_t>(number_of("bolt_shot")));
    const auto wand = match_sounds(poor, *data->presentation);
    ASSERT_EQ(wand.missing.size(), 1U);
    EXPECT_EQ(wand.missing[0].file, "wands/bolt.toml");
    EXPECT_EQ(wand.missing[0].key, "fire");
    for (const auto number : wand.cues) EXPECT_TRUE(number);
    poor = bank();
    poor.sounds.erase(poor.sounds.begin() + static_cast<std::ptrdiff_t>(number_of("heartbeat")));
    const auto cue = match_sounds(poor, *data->presentation);
    ASSERT_EQ(cue.missing.size(), 1U);
    EXPECT_NE(line_of(cue.missing[0]).find("heartbeat.toml"), std::string::npos) << line_of(cue.missing[0]);
    EXPECT_FALSE(cue.cues.at(static_cast<std::size_t>(Cue::heartbeat)));
    EXPECT_TRUE(cue.cues.at(static_cast<std::size_t>(Cue::jump)));
    poor.faulty.push_back({"heartbeat", {"assets/sounds/heartbeat.toml:3: faulty"}});
    EXPECT_EQ(match_sounds(poor, *data->presentation).missing.size(), 0U) << "the bank has told it";
}

// ---- sounds of scripted scenes ----------------------------------------------------------------------------

TEST(SoundScene, StepsFollowTheWay) {
    SoundRig rig;
    const vec3 from = rig.match.world().get<Motion>(rig.wizard(0)).position;
    rig.device.counts[input::hand::forward] = 127;
    rig.play(ticks(2));
    const double way = glm::distance(from, rig.match.world().get<Motion>(rig.wizard(0)).position);
    ASSERT_GT(way, 4);
    EXPECT_NEAR(rig.heard.begun["step_stone"], way / 1.5, 1);
    rig.device.counts[input::hand::forward] = 0;
    rig.play(ticks(0.5));
    const auto steps = rig.heard.begun["step_stone"];
    rig.play(ticks(2));
    EXPECT_EQ(rig.heard.begun["step_stone"], steps) << "nobody walks";
}

/// A barrel that the test drops.
ecs::Entity barrel_of(const Simulation& match) {
    ecs::Entity barrel{};
    match.world().view<const Prop, const Look>().each([&](ecs::Entity e, const Prop&, const Look& look) {
        if (look.surface == Surface::barrel) barrel = e;
    });
    return barrel;
}

/// Drops the barrel from 2 m above a place. Returns the voices (sounds that begin) of its impacts.
std::vector<Voice> drop_at(SoundRig& rig, ecs::Entity barrel, vec3 place) {
    auto body = rig.match.physics().state(barrel.index);
    body = {.position = place + vec3(0, 2, 0)};
    rig.match.physics().set_state(barrel.index, body);
    std::vector<Voice> blows;
    for (Tick t = 0; t < ticks(2); ++t) {
        rig.play(1);
        if (rig.match.now() % audio::frame_ticks != 0) continue;
        for (const auto& voice : rig.heard.frame.begins)
            if (voice.sound == number_of("hit_wood")) blows.push_back(voice);
    }
    return blows;
}

TEST(SoundScene, ADroppedThingIsHeardWhereItLandsAndOnce) {
    SoundRig rig;
    const auto barrel = barrel_of(rig.match);
    ASSERT_TRUE(barrel);
    rig.play(ticks(1));
    const vec3 rest = rig.match.physics().state(barrel.index).position;
    const auto blows = drop_at(rig, barrel, rest);
    ASSERT_GE(blows.size(), 1U);
    EXPECT_LE(blows.size(), 3U) << "a bounce or two";
    EXPECT_LT(glm::distance(blows[0].position, rest), 0.8);
    EXPECT_GT(blows[0].gain, 0.5) << "6 m/s";
}

/// A place on the floor that a wall hides from an ear, if `hidden`; otherwise one that no wall hides.
std::optional<vec3> place_on_floor(const Simulation& match, vec3 ear, bool hidden) {
    for (double x = -14; x <= 14; x += 1) {
        for (double z = -14; z <= 14; z += 1) {
            const auto floor = match.physics().ray({x, 6, z}, {x, -1, z}, layer::ground | layer::prop);
            if (!floor || std::abs(floor->point.y) > 0.05) continue;
            const vec3 place = floor->point + vec3(0, 0.6, 0);
            const auto wall = match.physics().ray(ear, place, layer::ground);
            const bool blocked = wall && glm::distance(wall->point, place) > 1;
            if (blocked == hidden && glm::distance(ear, place) < 30) return floor->point + vec3(0, 0.5, 0);
        }
    }
    return std::nullopt;
}

TEST(SoundScene, AWallMufflesAndAnOpenWayDoesNot) {
    SoundRig rig;
    const auto barrel = barrel_of(rig.match);
    const vec3 ear = rig.heard.frame.listeners[0].position;
    for (const bool hidden : {true, false}) {
        const auto place = place_on_floor(rig.match, ear, hidden);
        ASSERT_TRUE(place) << hidden;
        const auto blows = drop_at(rig, barrel, *place);
        ASSERT_GE(blows.size(), 1U);
        EXPECT_NEAR(blows[0].muffled[0], hidden ? 0.75 : 0, 1e-9);
    }
}

TEST(SoundScene, TheHeartIsHeardByItsOwnerOnlyAndFasterWithLessHealth) {
    SoundRig rig;
    const auto beats = [&](double health) {
        rig.match.world_to_change().get<Health>(rig.wizard(0)).points = health;
        const int before = rig.heard.begun["heartbeat"];
        rig.play(ticks(5));
        return rig.heard.begun["heartbeat"] - before;
    };
    EXPECT_EQ(beats(100), 0);
    const int slow = beats(24);
    for (const auto& voice : rig.heard.frame.begins)
        if (voice.sound == number_of("heartbeat")) {
            EXPECT_EQ(voice.heard_by, 1U);
        }
    const int fast = beats(2);
    EXPECT_NEAR(slow, 5 * 1.25, 1.5);
    EXPECT_NEAR(fast, 5 * 2.3, 1.5);
}

/// The lasting voice of a sound in the newest frame; null: the sound is not heard.
const Voice* lasting_voice(const AudioFrame& frame, std::string_view name) {
    for (const auto& voice : frame.lasts)
        if (voice.sound == number_of(name)) return &voice;
    return nullptr;
}

TEST(SoundScene, TheOrbHumsHigherAndLouderNearTheCore) {
    SoundRig rig;
    rig.play(audio::frame_ticks);
    EXPECT_EQ(lasting_voice(rig.heard.take(), "orb_hum"), nullptr) << "nobody scries";
    auto& world = rig.match.world_to_change();
    const auto& orb = world.single<Orb>();
    world.add(rig.wizard(0), Scrying{.place = orb.middle, .distance = 2 * orb.radius});
    double gain = 0, pitch = 0;
    for (const double distance : {1.0, 0.4, 0.1, 0.0}) {
        world.get<Scrying>(rig.wizard(0)).distance = distance * orb.radius;
        const auto* hum = lasting_voice(rig.heard.take(), "orb_hum");
        ASSERT_NE(hum, nullptr);
        EXPECT_EQ(hum->position, orb.middle);
        EXPECT_GT(hum->gain, gain) << distance;
        EXPECT_GT(hum->pitch, pitch) << distance;
        gain = hum->gain;
        pitch = hum->pitch;
    }
    EXPECT_DOUBLE_EQ(gain, 1);
    EXPECT_DOUBLE_EQ(pitch, 2) << "an octave above the hum far from the core";
}

TEST(SoundScene, ATouchedCrystalIsScrapedByForceAndSpeed) {
    SoundRig rig;
    rig.play(audio::frame_ticks);
    auto& world = rig.match.world_to_change();
    world.add(rig.wizard(0), Chisel{});
    const auto gain = [&](vec3 moved, double newtons, bool cuts) {
        auto& chisel = world.get<Chisel>(rig.wizard(0));
        chisel.force = vec3(0, newtons, 0);
        chisel.cutting = cuts ? 1 : 0;
        rig.heard.take();
        chisel.place += moved;
        const auto* scrape = lasting_voice(rig.heard.take(), "carve");
        return scrape == nullptr ? 0 : scrape->gain;
    };
    const vec3 slow(0.002, 0, 0), fast(0.006, 0, 0);
    EXPECT_EQ(gain(vec3(0), 1, false), 0) << "a tool that rests on the crystal";
    EXPECT_EQ(gain(fast, 0, false), 0) << "a tool that moves through the air";
    EXPECT_GT(gain(slow, 0.5, false), 0);
    EXPECT_GT(gain(fast, 0.5, false), gain(slow, 0.5, false));
    EXPECT_GT(gain(slow, 1, false), gain(slow, 0.5, false));
    EXPECT_GT(gain(slow, 0.5, true), gain(slow, 0.5, false)) << "it cuts";
}

TEST(SoundScene, TheStartIsHeardAndAfterTheEndNothingGoesOn) {
    SoundRig rig;
    EXPECT_EQ(rig.heard.begun["count_go"], 1);
    rig.device.counts[input::hand::forward] = 127;
    rig.play(ticks(1));
    ASSERT_GT(rig.heard.begun["step_stone"], 0);
    rig.match.world_to_change().single<Match>().phase = Phase::over;
    const auto before = rig.heard.begun;
    rig.play(ticks(1));
    EXPECT_EQ(rig.heard.begun["step_stone"], before.at("step_stone"))
        << "the wizard keeps his speed, but stands";
    for (const auto& voice : rig.heard.frame.lasts)
        EXPECT_EQ(bank().sounds[voice.sound].group, audio::SoundGroup::music);
}

TEST(SoundScene, TheEndOfARoundIsHeardAsWonLostOrDrawn) {
    for (const std::uint32_t winner : {0U, 1U, no_player}) {
        SoundRig rig;
        if (winner < players)
            rig.match.world_to_change().get<Score>(rig.wizard(winner)).kills = rig.match.data().round.kills;
        auto& match = rig.match.world_to_change().single<Match>();
        match.boils_over_since = winner < players ? 0 : 1;
        match.played = round_ends_at(rig.match.data().round, match) - ticks(0.1);
        std::map<std::string, std::uint32_t> heard_by;
        for (Tick t = 0; t < ticks(0.2); t += audio::frame_ticks) {
            rig.play(audio::frame_ticks);
            for (const auto& voice : rig.heard.frame.begins)
                if (voice.at_ear) heard_by[bank().sounds[voice.sound].name] |= voice.heard_by;
        }
        EXPECT_EQ(rig.match.match().winner, winner);
        EXPECT_EQ(heard_by["round_won"], winner < players ? 1U << winner : 0U) << winner;
        EXPECT_EQ(heard_by["round_lost"], winner < players ? 3U - (1U << winner) : 0U) << winner;
        EXPECT_EQ(heard_by["round_drawn"], winner < players ? 0U : 3U) << winner;
    }
}

TEST(SoundScene, AFallIsHeardAtTheOwnEarAndByTheOtherFromItsPlace) {
    SoundRig rig;
    record(rig.match.context_to_change(), {.tick = rig.match.match().played,
                                           .kind = EventKind::fall,
                                           .subject = 0,
                                           .amount = 20,
                                           .place = {5, -5, 5}});
    rig.play(audio::frame_ticks);
    ASSERT_EQ(rig.heard.frame.begins.count, 2U);
    for (const auto& voice : rig.heard.frame.begins)
        EXPECT_EQ(voice.at_ear, voice.heard_by == 1) << voice.heard_by;
}

TEST(SoundScene, APauseAndAJumpOfTheClockBeginNothing) {
    SoundRig rig;
    rig.device.counts[input::hand::forward] = 127;
    rig.play(ticks(1));
    rig.match.world_to_change().single<Match>().paused = 1;
    const auto before = rig.heard.begun;
    rig.play(ticks(1));
    EXPECT_EQ(rig.heard.begun, before);
    rig.match.world_to_change().single<Match>().paused = 0;
    // The match plays for two seconds in which no frame of sound is taken.
    for (Tick t = 0; t < ticks(2); ++t) {
        input::InputFrame frame;
        frame.devices[0] = rig.device;
        rig.match.tick(frame);
    }
    rig.heard.take();
    EXPECT_EQ(rig.heard.frame.begins.count, 0U);
}

// ---- scenes played by the mixer ---------------------------------------------------------------------------

/// Samples that one speaker plays of a sound that begins, or lasts, two metres ahead of the listener.
std::vector<float> played_by(audio::Mixer& mixer, std::uint32_t sound) {
    const auto& kind = bank().sounds[sound];
    audio::AudioFrame frame;
    const Voice voice{.sound = sound, .key = 1, .position = {0, 0, -2}};
    if (!kind.loops) frame.begins.add(voice);
    std::vector<float> left;
    std::array<float, audio::block_values> block{};
    for (std::size_t done = 0; done < kind.samples.size() + 4 * audio::frame_samples;
         done += audio::frame_samples) {
        if (kind.loops) frame.lasts = {.voices = {voice}, .count = 1, .left_out = 0};
        mixer.play(frame, block);
        frame.begins.count = 0;
        for (std::size_t i = 0; i < block.size(); i += 2) left.push_back(block.at(i));
    }
    mixer.silence();
    return left;
}

TEST(SoundLoopback, EachSoundComesOutOfTheMixerAsItself) {
    auto mixer = audio::Mixer::create(bank(), {}).value();
    std::vector<audio::Signature> known;
    for (const auto& sound : bank().sounds) known.push_back(audio::signature_of(sound.samples));
    std::size_t wrong = 0;
    for (std::uint32_t i = 0; i < known.size(); ++i) {
        const auto heard = played_by(mixer, i);
        EXPECT_LT(audio::loudest_db(heard), 0) << bank().sounds[i].name;
        EXPECT_GT(audio::loudest_db(heard), -45) << bank().sounds[i].name << " is silent";
        const auto signature = audio::signature_of(heard);
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < known.size(); ++k)
            if (audio::distance(signature, known[k]) < audio::distance(signature, known[nearest]))
                nearest = k;
        if (nearest == i) continue;
        ++wrong;
        std::printf("%s is taken for %s\n", bank().sounds[i].name.c_str(),
                    bank().sounds[nearest].name.c_str());
    }
    EXPECT_LE(wrong, known.size() / 20);
}

// ---- captions of sounds -----------------------------------------------------------------------------------

TEST(Heard, TheSideIsThatOfTheListener) {
    const audio::Listener ears{.position = {1, 2, 3}, .forward = {1, 0, 0}, .up = {0, 1, 0}};
    const auto side = [&](vec3 away) { return side_of(ears, ears.position + away); };
    EXPECT_EQ(side({5, 0, 0}), HeardFrom::ahead);
    EXPECT_EQ(side({-5, 0, 0}), HeardFrom::behind);
    EXPECT_EQ(side({0, 0, 5}), HeardFrom::right);
    EXPECT_EQ(side({0, 0, -5}), HeardFrom::left);
    EXPECT_EQ(side({1, 5, 0}), HeardFrom::above);
    EXPECT_EQ(side({0, -5, 1}), HeardFrom::below);
    EXPECT_EQ(side({0.5, 0.2, 0}), HeardFrom::here);
    EXPECT_EQ(side({0.5, -1.6, 0}), HeardFrom::here) << "the own feet";
    EXPECT_EQ(side({4, 0, 3.9}), HeardFrom::ahead);
    EXPECT_EQ(side({3.9, 0, 4}), HeardFrom::right);
}

/// A frame with one listener at the origin who looks along -z.
AudioFrame frame_with(std::initializer_list<std::pair<const char*, vec3>> begins) {
    AudioFrame frame;
    for (const auto& [name, place] : begins) frame.begins.add({.sound = number_of(name), .position = place});
    return frame;
}

TEST(Heard, EqualSoundsFromOneSideAreOneLineThatStays) {
    HeardLines heard;
    heard.follow(frame_with({{"step_stone", {0, 0, 5}}}), bank(), 0);
    heard.follow(frame_with({{"step_stone", {0.5, 0, 6}}, {"bolt_shot", {5, 0, 0}}}), bank(), 0);
    ASSERT_EQ(heard.lines().size(), 2U);
    EXPECT_EQ(heard.lines()[0].words, "step");
    EXPECT_EQ(heard.lines()[0].from, HeardFrom::behind);
    EXPECT_EQ(heard.lines()[0].age_s, 0);
    EXPECT_EQ(heard.lines()[1].from, HeardFrom::right);
    EXPECT_TRUE(heard.lines()[1].important);
    for (int i = 0; i < 201; ++i) heard.pass_frame();
    EXPECT_EQ(heard.lines().size(), 0U) << "1.6 s later";
}

TEST(Heard, WhatIsOutOfReachOrForTheOtherPlayerHasNoWords) {
    HeardLines heard;
    heard.follow(frame_with({{"step_stone", {0, 0, 200}}}), bank(), 0);
    AudioFrame other;
    other.begins.add({.sound = number_of("wand_dry"), .heard_by = 2, .at_ear = true});
    heard.follow(other, bank(), 0);
    EXPECT_EQ(heard.lines().size(), 0U);
    heard.follow(other, bank(), 1);
    EXPECT_EQ(heard.lines().size(), 1U);
}

TEST(Heard, AFullListKeepsWhatIsImportant) {
    HeardLines heard;
    heard.follow(frame_with({{"death", {0, 0, -5}}}), bank(), 0);
    for (const char* name : {"step_stone", "step_wood", "step_metal", "hit_wood", "hit_stone", "hit_metal",
                             "hit_soft", "jump", "land", "splash", "hit_wizard"})
        heard.follow(frame_with({{name, {0, 0, -5}}}), bank(), 0);
    EXPECT_EQ(heard.lines().size(), 8U);
    EXPECT_EQ(heard.lines()[0].words, "death");
    EXPECT_EQ(heard.lines()[7].words, "hit");
}

TEST(Heard, MusicIsToldWhenItBeginsAndNotAllTheTime) {
    HeardLines heard;
    AudioFrame frame;
    frame.lasts.add({.sound = number_of("music_calm"), .key = 50, .at_ear = true, .gain = 0.5});
    heard.follow(frame, bank(), 0);
    EXPECT_EQ(heard.lines().size(), 1U);
    for (int i = 0; i < 250; ++i) {
        heard.pass_frame();
        heard.follow(frame, bank(), 0);
    }
    EXPECT_EQ(heard.lines().size(), 0U);
}

}  // namespace
}  // namespace thaum::game::test
