// game/bots/bot.h: an opponent that plays through a device, as a person does.
//
// A bot sees what a player could see (things in its field of view and not behind others, with a delay), decides, and emits
// one device sample a tick. It belongs to the devices, not to the match: the log holds its samples, and a replay runs
// without it. Its mind lives in a World of its own, so that a match with bots can be saved and continued whole.
#pragma once
#include <filesystem>
#include <memory>

#include "core/bytes.h"
#include "game/match/simulation.h"

namespace thaum::game {

/// From assets/bots/level_N.toml.
struct BotSkill {
    std::uint32_t level{};
    Tick reaction{};       ///< ticks from light to hand
    double aim_error{};    ///< rad, one standard deviation
    double turn_speed{};   ///< rad/s
    double view_cos{};     ///< cosine of half its field of view
    Tick burst{}, rest{};  ///< ticks of fire, and between
    double keep{};         ///< m, the distance it likes
};

Expected<BotSkill> load_bot_skill(const std::filesystem::path& assets, int level);

/// How a bot's device counts: as a mouse's.
input::DeviceSpec bot_device(std::uint32_t player, int level);

class Bots {
public:
    Bots();
    ~Bots();
    Bots(Bots&&) noexcept;
    Bots& operator=(Bots&&) noexcept;

    /// Device number `device` of the match's frames is played by a bot for `player`.
    void add(const Simulation& match, std::size_t device, std::uint32_t player, const BotSkill& skill,
             std::uint64_t seed);
    bool empty() const;
    /// Fills the samples of all bots for the next tick of the match.
    void sample(const Simulation& match, input::InputFrame& frame);

    void save(Bytes& out) const;
    Expected<void> restore(std::span<const std::byte> snapshot);

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace thaum::game
