// game/range/dummy.h: a target for practice. A dummy plays through a device and sees no more than a bot does,
// but it only stands, walks to and fro or shoots.
#pragma once
#include "game/bots/mind.h"
#include "game/bots/nav.h"

namespace thaum::game::inline range {

enum class DummyKind : std::uint8_t {
    still,
    /// Walks sideways to and fro around the place where it came to life; reverses at walls, edges and
    /// obstacles.
    strafing,
    shooting,  ///< stands, turns to a foe in sight and shoots
};
inline constexpr std::array<std::string_view, 3> dummy_names{"still", "strafing", "shooting"};

struct DummyRules {
    double stride{};   ///< distance that a strafing dummy walks to each side (m)
    BotSkill skill{};  ///< how well a shooting dummy aims and how fast it reacts (skill of a bot)
};

class Dummy {
public:
    /// Creates a dummy that plays for `player`.
    Dummy(const Simulation& match, std::uint32_t player, DummyKind kind, const DummyRules& rules,
          std::uint64_t seed);

    DummyKind kind() const { return kind_; }
    const DummyRules& rules() const { return rules_; }
    void become(DummyKind kind);
    /// Continues with changed data of the match, or with changed rules for dummies.
    void adopt(const Simulation& match, const DummyRules& rules);

    /// The dummy's input (device sample) for the next tick of the match.
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
    bool begins_ = true;          ///< true: at the next gameplay tick the dummy forgets what it saw and how
                                  ///< it walked
    std::optional<vec3> home_{};  ///< place where the dummy came to life; std::nullopt while it is dead
    std::int32_t way_ = 1;        ///< direction of walking: 1 to its right, -1 to its left
    Tick walked_at_{};            ///< when the dummy last made progress in walking (ticks of play)
    Tick turned_at_{};
};

}  // namespace thaum::game::inline range
