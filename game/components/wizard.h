// game/components/wizard.h: what a wizard is and does. Each part has its own component, so that a system touches
// only what it is about.
#pragma once
#include "core/units.h"
#include "ecs/component.h"
#include "physics/mover.h"

namespace thaum::game {

using ecs::field;

inline constexpr std::size_t players = 2;
inline constexpr std::size_t wand_slots = 5;

struct Wizard {
    std::uint32_t player{};  ///< 0 or 1
    static constexpr std::string_view name = "Wizard";
    static constexpr auto fields() { return std::tuple(field("player", &Wizard::player)); }
};

/// This tick's device sample, as the player meant it.
struct Controls {
    std::uint32_t held{};     ///< input::Button bits
    std::uint32_t pressed{};  ///< went down since gameplay last looked
    std::int32_t strafe{};    ///< -127..127, right +
    std::int32_t forward{};   ///< -127..127
    std::int32_t trigger{};   ///< 0..255
    std::int32_t wheel{};     ///< steps since gameplay last looked
    std::int32_t hand_right{}, hand_up{},
        hand_back{};  ///< um: where clutch or ladle move the hand in this tick
    static constexpr std::string_view name = "Controls";
    static constexpr auto fields() {
        return std::tuple(field("held", &Controls::held), field("pressed", &Controls::pressed),
                          field("strafe", &Controls::strafe), field("forward", &Controls::forward),
                          field("trigger", &Controls::trigger), field("wheel", &Controls::wheel),
                          field("hand_right", &Controls::hand_right), field("hand_up", &Controls::hand_up),
                          field("hand_back", &Controls::hand_back));
    }
};

/// Where the wizard looks: yaw to the left of -z, pitch up, rad.
struct Gaze {
    double yaw{};
    double pitch{};
    static constexpr std::string_view name = "Gaze";
    static constexpr auto fields() {
        return std::tuple(field("yaw", &Gaze::yaw), field("pitch", &Gaze::pitch));
    }
};

/// How the wizard stands; the mover's memory.
struct Stance : physics::MoverState {
    double hung{};  ///< N, upward, by a rope
    static constexpr std::string_view name = "Stance";
    static constexpr auto fields() {
        return std::tuple(field("expected", &Stance::expected),
                          field("ground_normal", &Stance::ground_normal), field("falling", &Stance::falling),
                          field("grounded", &Stance::grounded), field("driven", &Stance::driven),
                          field("hung", &Stance::hung));
    }
};

struct Health {
    double points{};           ///< HP
    Tick shielded_until{};     ///< nothing hurts before that tick
    Tick hurt_at{};            ///< when something last hurt
    std::uint32_t hurt_by{};   ///< by whom: a player, or no_player
    std::uint32_t hurt_how{};  ///< EventKind
    Tick foe_did_at{};         ///< when the foe last hurt it; 0: never
    static constexpr std::string_view name = "Health";
    static constexpr auto fields() {
        return std::tuple(field("points", &Health::points), field("shielded_until", &Health::shielded_until),
                          field("hurt_at", &Health::hurt_at), field("hurt_by", &Health::hurt_by),
                          field("hurt_how", &Health::hurt_how), field("foe_did_at", &Health::foe_did_at));
    }
};

/// Dead, and coming back.
struct Dead {
    Tick returns_at{};
    static constexpr std::string_view name = "Dead";
    static constexpr auto fields() { return std::tuple(field("returns_at", &Dead::returns_at)); }
};

/// One thing that is hitting this wizard: its impulse is summed over the blow before it counts.
struct Blow {
    ecs::Entity by{};
    Tick began{};
    Tick counts_again{};  ///< no further hit from this thing before that
    double impulse{};     ///< N s so far; negative once it was counted
    static constexpr auto fields() {
        return std::tuple(field("by", &Blow::by), field("began", &Blow::began),
                          field("counts_again", &Blow::counts_again), field("impulse", &Blow::impulse));
    }
};

struct Blows {
    std::array<Blow, 8> recent{};
    static constexpr std::string_view name = "Blows";
    static constexpr auto fields() { return std::tuple(field("recent", &Blows::recent)); }
};

struct WandBelt {
    std::uint32_t selected{};
    std::uint32_t fired{};                    ///< shots so far, all wands
    std::array<double, wand_slots> energy{};  ///< by WandStats::energy_slot
    static constexpr std::string_view name = "WandBelt";
    static constexpr auto fields() {
        return std::tuple(field("selected", &WandBelt::selected), field("fired", &WandBelt::fired),
                          field("energy", &WandBelt::energy));
    }
};

struct Score {
    std::int32_t kills{};
    std::int32_t deaths{};
    static constexpr std::string_view name = "Score";
    static constexpr auto fields() {
        return std::tuple(field("kills", &Score::kills), field("deaths", &Score::deaths));
    }
};

}  // namespace thaum::game
