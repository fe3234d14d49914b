// game/senses/sound/cues.h: the cues: sounds that the state of a match causes rather than a single event.
// Each has a file in assets/sounds.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "audio/sound.h"
#include "game/components/body.h"

namespace thaum::game::inline senses {

enum class Cue : std::uint8_t {
    step_stone,
    step_wood,
    step_metal,
    jump,
    land,
    hit_wood,
    hit_stone,
    hit_metal,
    hit_soft,
    heartbeat,
    wand_change,
    stir,
    boil,
    splash,
    orb_hum,
    carve,
    count_tick,
    count_go,
    last_seconds,
    round_won,
    round_lost,
    round_drawn,
    music_calm,
    music_pulse,
    music_tension,
    music_final,
    count
};
inline constexpr std::size_t cues = static_cast<std::size_t>(Cue::count);
inline constexpr std::array<std::string_view, cues> cue_names{
    "step_stone",  "step_wood",  "step_metal",  "jump",          "land",         "hit_wood",  "hit_stone",
    "hit_metal",   "hit_soft",   "heartbeat",   "wand_change",   "stir",         "boil",      "splash",
    "orb_hum",     "carve",      "count_tick",  "count_go",      "last_seconds", "round_won", "round_lost",
    "round_drawn", "music_calm", "music_pulse", "music_tension", "music_final"};

/// Materials of things and ground, by which a blow or a step sounds.
enum class Material : std::uint8_t { stone, wood, metal, soft };
Material material_of(Surface surface);
Cue step_on(Material material);
Cue hit_on(Material material);

/// Number of a sound in the bank of all loaded sounds; std::nullopt: silence.
using SoundNumber = std::optional<std::uint32_t>;
/// Number of each cue's sound in the bank of all loaded sounds. A cue is a sound that the state of a match
/// causes.
using CueSounds = std::array<SoundNumber, cues>;

}  // namespace thaum::game::inline senses
