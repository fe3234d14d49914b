// game/bots/dummy.h: whom one practises on. A dummy plays through a device, as bots do, and sees no more than they; but it
// has one thing to do and nothing else in mind.
#pragma once
#include "game/bots/mind.h"
#include "game/bots/nav.h"

namespace thaum::game {

enum class DummyKind : std::uint8_t {
    still,
    strafing,  ///< walks sideways to and fro about the place where it came to life; turns at walls, edges and obstacles
    shooting,  ///< stands, turns to whom it sees and shoots
};
inline constexpr std::array<std::string_view, 3> dummy_names{"still", "strafing", "shooting"};

struct DummyRules {
    double stride{};   ///< m to each side of where it came to life; of the strafing one
    BotSkill skill{};  ///< of the shooting one
};

class Dummy {
public:
    /// Plays for `player`.
    Dummy(const Simulation& match, std::uint32_t player, DummyKind kind, const DummyRules& rules,
          std::uint64_t seed);

    DummyKind kind() const { return kind_; }
    void become(DummyKind kind);
    /// The match goes on by other data, or these are other rules.
    void adopt(const Simulation& match, const DummyRules& rules);

    /// What its device does in the next tick of the match.
    input::DeviceSample sample(const Simulation& match);

private:
    void begin(Tick tick);
    void think(const Simulation& match);
    void walk_to_and_fro(const Self& self, Tick tick);
    void shoot(const Simulation& match, const Self& self, Tick tick);

    DummyKind kind_{};
    DummyRules rules_;
    Seat seat_;
    Eyes eyes_{};
    Mind mind_{};
    WalkGrid grid_;
    bool begins_ = true;          ///< has forgotten what it did
    std::optional<vec3> home_{};  ///< where it came to life; nothing while it is dead
    std::int32_t way_ = 1;        ///< 1: to its right, -1: to its left
    Tick walked_at_{};            ///< when it last got on
    Tick turned_at_{};
};

}  // namespace thaum::game
