// game/hud/prompts.h: prompts, which tell a player what to do now and with which control: "[E] Stir". A
// prompt becomes fainter each time the player has done what it says, and disappears after the third time.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "game/components/station.h"
#include "game/data/control_names.h"
#include "game/picture/picture.h"

namespace thaum::game::inline hud {

enum class PromptKind : std::uint8_t {
    stir,
    drop,
    lift,
    throw_thing,
    swing,
    cast,
    put_away,
    scry,
    carve,
    draw_curve
};
inline constexpr std::size_t prompt_kinds = 10;

/// A player's attempt to use a station (cauldron, orb or crystal) from too far away.
struct MissedStation {
    Tick at{};
    StationKind station{};
    bool operator==(const MissedStation&) const = default;
};

/// How often each player has done what each prompt asks for, and the last failed attempt at a station.
struct PromptUses {
    static constexpr std::uint32_t learnt = 3;  ///< number of uses after which a prompt is no longer shown
    std::array<std::array<std::uint32_t, prompt_kinds>, players> count{};
    /// Last time that the player pressed the button Stir too far from a station or was pushed away from it;
    /// std::nullopt: never, or using a station has succeeded since.
    std::array<std::optional<MissedStation>, players> missed{};
    bool operator==(const PromptUses&) const = default;

    std::uint32_t& of(std::uint32_t player, PromptKind kind) {
        return count[player][static_cast<std::size_t>(kind)];
    }
    std::uint32_t of(std::uint32_t player, PromptKind kind) const {
        return count[player][static_cast<std::size_t>(kind)];
    }
};

struct Prompt {
    PromptKind kind{};
    std::string words;
};

/// The prompt for the player's most useful action; std::nullopt if there is none, or if no control is bound
/// to it.
std::optional<Prompt> prompt_of(const PlayerPicture& player, const ControlNames& controls);

/// Words for a player who has just pressed the button Stir too far from a station (cauldron, orb or crystal),
/// or was pushed away from it; empty for other players. `now`: the picture's tick.
std::string_view words_of_missed_station(Tick now, std::uint32_t player, const PromptUses& uses);

/// Opacity of a prompt, 0 to 1.
float strength_of(const Prompt& prompt, std::uint32_t player, PromptWish wish, const PromptUses& uses);

/// Counts the actions of players between two pictures of a match.
void count_uses(const Picture& before, const Picture& after, PromptUses& uses);

}  // namespace thaum::game::inline hud
