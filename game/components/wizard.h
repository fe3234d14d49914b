// game/components/wizard.h: state of a wizard. Each part is a component of its own, so that a system declares
// and reads only the parts it needs.
#pragma once
#include "core/units.h"
#include "ecs/component.h"
#include "input/frame.h"
#include "physics/mover.h"

namespace thaum::game::inline components {

inline constexpr std::size_t players = 2;
inline constexpr std::size_t wand_slots = input::max_wands;

struct Wizard {
    std::uint32_t player{};  ///< number of the player: 0 or 1
    THAUM_COMPONENT(Wizard, player);
};

/// The player's input in this tick, decoded from the device sample.
struct Controls {
    std::uint32_t held{};          ///< buttons that are down (bits of input::Button)
    std::uint32_t pressed{};       ///< buttons pressed since the last gameplay tick (bits of input::Button)
    std::uint32_t wand_held{};     ///< wand whose key is down, 1 to wand_slots; 0: none
    std::uint32_t wand_pressed{};  ///< wand whose key was pressed last since the last gameplay tick; 0: none
    std::int32_t strafe{};         ///< motion sideways, -127 to 127; positive: right
    std::int32_t forward{};        ///< forward motion, -127 to 127; negative: backward
    std::int32_t trigger{};        ///< position of the trigger, 0 to 255
    std::int32_t wheel{};          ///< steps by which the mouse wheel was turned since the last gameplay tick
    /// Displacement of the hand in this tick (um, device frame). The input moves the hand, instead of the
    /// view, while the player works at a station or holds one of the buttons Clutch and Trace.
    std::int32_t hand_right{}, hand_up{}, hand_back{};
    /// Displacement of the hand from its home by a stick, while the button Trace is held (um, device frame).
    std::int32_t stick_right{}, stick_up{};
    /// 1: fire was pressed while the button Trace was held, so a spell cast by a wand's key is harsh
    /// (stronger).
    std::uint32_t harsh{};
    /// 1: the stick has been at its rim since the button Trace went down, so it moves the hand.
    std::uint32_t stick_draws{};
    THAUM_COMPONENT(Controls, held, pressed, wand_held, wand_pressed, strafe, forward, trigger, wheel,
                    hand_right, hand_up, hand_back, stick_right, stick_up, harsh, stick_draws);
};

/// Direction of view: yaw counts to the left from -z, pitch upwards (rad).
struct Gaze {
    double yaw{};
    double pitch{};
    THAUM_COMPONENT(Gaze, yaw, pitch);
};

/// How the wizard stands: the state that physics::Mover, which moves the wizard's body, needs again in the
/// next tick.
struct Stance : physics::MoverState {
    double rope_lift{};  ///< upward part of the rope's force (N)
    Tick loose_until{};  ///< tick before which the feet slip on the ground after a push
    THAUM_COMPONENT(Stance, expected, ground_normal, falling, grounded, driven, rope_lift, loose_until);
};

/// Health that no wizard reaches (HP).
inline constexpr double no_health_limit = 1e6;

struct Health {
    double points{};           ///< health that the wizard has left (HP)
    Tick shielded_until{};     ///< tick before which nothing hurts the wizard, after a return to life
    Tick hurt_at{};            ///< tick of play at which the wizard was last hurt
    std::uint32_t hurt_by{};   ///< player who last hurt the wizard; no_player: none
    std::uint32_t hurt_how{};  ///< how the wizard was last hurt, an EventKind
    Tick foe_did_at{};         ///< tick at which the foe last hurt or pushed the wizard; 0: never
    /// Largest health that the wizard may have now, if less than that of the data: in the Boil-over (HP)
    double limit{no_health_limit};
    double surge{1};    ///< factor on the harm that the other player does to the wizard now
    double ward{};      ///< harm that the wizard's shield can still absorb (HP)
    Tick ward_until{};  ///< tick of play at which the shield ends
    double poison{};    ///< harm by poison for each second, until `poisoned_until` (HP/s)
    Tick poisoned_until{};
    std::uint32_t poisoned_by{};  ///< player who poisoned the wizard
    std::uint32_t spare{};
    THAUM_COMPONENT(Health, points, shielded_until, hurt_at, hurt_by, hurt_how, foe_did_at, limit, surge,
                    ward, ward_until, poison, poisoned_until, poisoned_by, spare);
};

/// State of a dead wizard.
struct Dead {
    Tick returns_at{};
    THAUM_COMPONENT(Dead, returns_at);
};

/// A blow by a thing that is in contact with the wizard. Its impulse is summed until the blow ends, then
/// turned into harm once.
struct Blow {
    ecs::Entity by{};
    Tick began{};
    Tick counts_again{};  ///< tick before which another hit by the same thing is ignored
    double impulse{};     ///< impulse of the blow so far (N s); negative once the harm has been applied
    THAUM_FIELDS(Blow, by, began, counts_again, impulse);
};

/// Blows of the last few things that hit the wizard.
struct Blows {
    std::array<Blow, 8> recent{};
    THAUM_COMPONENT(Blows, recent);
};

struct WandBelt {
    std::uint32_t selected{};
    std::uint32_t fired{};  ///< number of shots so far, over all wands
    /// Energy of the wands, by slot (the number of a wand's key). A wand may share the energy of another
    /// wand's slot (WandStats::energy_slot).
    std::array<double, wand_slots> energy{};
    /// Harm rate by poison that the next lob (a missile thrown in an arc) adds for those whom it hits (HP/s);
    /// 0: none.
    double venom{};
    Tick venom_until{};  ///< tick of play by which the poisoned missile must be thrown
    Tick venom_lasts{};  ///< duration of the poison's harm to those whom the missile hits (ticks)
    THAUM_COMPONENT(WandBelt, selected, fired, energy, venom, venom_until, venom_lasts);
};

struct Score {
    std::int32_t kills{};
    std::int32_t deaths{};
    THAUM_COMPONENT(Score, kills, deaths);
};

}  // namespace thaum::game::inline components
