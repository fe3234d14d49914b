// game/components/wizard.h: state of a wizard. Each part is a component of its own, so that a system declares
// and reads only the parts it needs.
#pragma once
#include "core/units.h"
#include "ecs/component.h"
#include "input/frame.h"
#include "physics/mover.h"

namespace thaum::game {

using ecs::field;

inline constexpr std::size_t players = 2;
inline constexpr std::size_t wand_slots = input::most_wands;

struct Wizard {
    std::uint32_t player{};  ///< 0 or 1
    static constexpr std::string_view name = "Wizard";
    static constexpr auto fields() { return std::tuple(field("player", &Wizard::player)); }
};

/// The player's input in this tick, decoded from the device sample.
struct Controls {
    std::uint32_t held{};          ///< buttons that are down (bits of input::Button)
    std::uint32_t pressed{};       ///< buttons pressed since the last gameplay tick (bits of input::Button)
    std::uint32_t wand_held{};     ///< wand whose key is down, 1 to wand_slots; 0: none
    std::uint32_t wand_pressed{};  ///< wand whose key was pressed last since the last gameplay tick; 0: none
    std::int32_t strafe{};         ///< sideways, -127 to 127; positive: right
    std::int32_t forward{};        ///< -127 to 127
    std::int32_t trigger{};        ///< 0 to 255
    std::int32_t wheel{};          ///< wheel steps since the last gameplay tick
    /// Displacement of the hand in this tick while clutch, ladle or Trace is in use (um, device frame).
    std::int32_t hand_right{}, hand_up{}, hand_back{};
    /// Displacement of the hand from its home by a stick, while Trace is held (um, device frame).
    std::int32_t stick_right{}, stick_up{};
    std::uint32_t harsh{};  ///< 1: fire was pressed while Trace is held, which makes a key chord harsh
    std::uint32_t
        stick_draws{};  ///< 1: the stick has been at its rim since Trace went down, so it moves the hand
    static constexpr std::string_view name = "Controls";
    static constexpr auto fields() {
        return std::tuple(field("held", &Controls::held), field("pressed", &Controls::pressed),
                          field("wand_held", &Controls::wand_held),
                          field("wand_pressed", &Controls::wand_pressed), field("strafe", &Controls::strafe),
                          field("forward", &Controls::forward), field("trigger", &Controls::trigger),
                          field("wheel", &Controls::wheel), field("hand_right", &Controls::hand_right),
                          field("hand_up", &Controls::hand_up), field("hand_back", &Controls::hand_back),
                          field("stick_right", &Controls::stick_right),
                          field("stick_up", &Controls::stick_up), field("harsh", &Controls::harsh),
                          field("stick_draws", &Controls::stick_draws));
    }
};

/// Direction of view: yaw counts to the left from -z, pitch upwards (rad).
struct Gaze {
    double yaw{};
    double pitch{};
    static constexpr std::string_view name = "Gaze";
    static constexpr auto fields() {
        return std::tuple(field("yaw", &Gaze::yaw), field("pitch", &Gaze::pitch));
    }
};

/// How the wizard stands: the mover's state between steps.
struct Stance : physics::MoverState {
    double rope_lift{};  ///< upward part of the rope's force (N)
    Tick loose_until{};  ///< tick before which the feet slip on the ground after a push
    static constexpr std::string_view name = "Stance";
    static constexpr auto fields() {
        return std::tuple(field("expected", &Stance::expected),
                          field("ground_normal", &Stance::ground_normal), field("falling", &Stance::falling),
                          field("grounded", &Stance::grounded), field("driven", &Stance::driven),
                          field("hung", &Stance::rope_lift), field("loose_until", &Stance::loose_until));
    }
};

struct Health {
    double points{};           ///< health left (HP)
    Tick shielded_until{};     ///< tick before which nothing hurts the wizard
    Tick hurt_at{};            ///< tick of the last injury
    std::uint32_t hurt_by{};   ///< player who caused the last injury; no_player: none
    std::uint32_t hurt_how{};  ///< EventKind of the last injury
    Tick foe_did_at{};         ///< tick at which the other player last hurt this wizard; 0: never
    double ward{};             ///< harm that a shield still takes in the wizard's place (HP)
    Tick ward_until{};         ///< tick at which that shield ends
    double harm_share{1};      ///< share of every harm that a potion leaves, before `hardened_until`
    Tick hardened_until{};
    double poison{};  ///< harm by a poison before `poisoned_until` (HP/s)
    Tick poisoned_until{};
    std::uint32_t poisoned_by{};  ///< player who poisoned the wizard
    std::uint32_t spare{};
    static constexpr std::string_view name = "Health";
    static constexpr auto fields() {
        return std::tuple(field("points", &Health::points), field("shielded_until", &Health::shielded_until),
                          field("hurt_at", &Health::hurt_at), field("hurt_by", &Health::hurt_by),
                          field("hurt_how", &Health::hurt_how), field("foe_did_at", &Health::foe_did_at),
                          field("ward", &Health::ward), field("ward_until", &Health::ward_until),
                          field("harm_share", &Health::harm_share),
                          field("hardened_until", &Health::hardened_until), field("poison", &Health::poison),
                          field("poisoned_until", &Health::poisoned_until),
                          field("poisoned_by", &Health::poisoned_by), field("spare", &Health::spare));
    }
};

/// State of a dead wizard.
struct Dead {
    Tick returns_at{};
    static constexpr std::string_view name = "Dead";
    static constexpr auto fields() { return std::tuple(field("returns_at", &Dead::returns_at)); }
};

/// Blow by one thing that is hitting this wizard. Its impulse is summed until the blow ends, then turned into
/// harm once.
struct Blow {
    ecs::Entity by{};
    Tick began{};
    Tick counts_again{};  ///< tick before which another hit by this thing is ignored
    double impulse{};     ///< impulse so far (N s); negative after the harm was counted
    static constexpr auto fields() {
        return std::tuple(field("by", &Blow::by), field("began", &Blow::began),
                          field("counts_again", &Blow::counts_again), field("impulse", &Blow::impulse));
    }
    /// Blows of the last few things that hit the wizard.
};

struct Blows {
    std::array<Blow, 8> recent{};
    static constexpr std::string_view name = "Blows";
    static constexpr auto fields() { return std::tuple(field("recent", &Blows::recent)); }
};

struct WandBelt {
    std::uint32_t selected{};
    std::uint32_t fired{};                    ///< number of shots so far, over all wands
    std::array<double, wand_slots> energy{};  ///< energy of each slot, indexed by WandStats::energy_slot
    double venom{};      ///< harm that the next lob adds to those whom it hits (HP/s); 0: none
    Tick venom_until{};  ///< tick before which that lob must be thrown
    Tick venom_lasts{};  ///< time for which that harm goes on
    static constexpr std::string_view name = "WandBelt";
    static constexpr auto fields() {
        return std::tuple(field("selected", &WandBelt::selected), field("fired", &WandBelt::fired),
                          field("energy", &WandBelt::energy), field("venom", &WandBelt::venom),
                          field("venom_until", &WandBelt::venom_until),
                          field("venom_lasts", &WandBelt::venom_lasts));
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
