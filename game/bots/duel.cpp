#include "game/bots/duel.h"

#include "game/bots/bot_file.h"

namespace thaum::game::inline bots {

input::InputFrame BotDuel::next_frame() {
    input::InputFrame frame;
    bots.sample(*match, frame);
    return frame;
}

void BotDuel::run(Tick count) {
    for (Tick t = 0; t < count; ++t) match->tick(next_frame());
}

Expected<BotDuel> make_bot_duel(const std::filesystem::path& assets, std::shared_ptr<const MatchData> data,
                                std::array<std::string, players> names, std::uint64_t seed) {
    MatchSetup setup{seed, {}};
    for (std::uint32_t player = 0; player < players; ++player) {
        setup.devices.push_back(bot_device(player, names[player]));
    }
    BotDuel duel{std::make_unique<Simulation>(std::move(data), std::move(setup)), {}};
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto skill = load_bot_skill(assets, names[player]);
        if (!skill) return skill.error();
        duel.bots.add(*duel.match, player, player, *skill, seed);
    }
    return duel;
}

}  // namespace thaum::game::inline bots
