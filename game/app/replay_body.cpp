#include "game/app/replay_body.h"

#include "core/text.h"

namespace thaum::app {

Expected<ReplayBody> ReplayBody::create(const game::MatchData& data, const std::filesystem::path& assets) {
    auto body = LiveBody::load(assets);
    if (!body) return tl::unexpected(body.error());
    auto effects = game::match_effects(body->effects, *data.presentation);
    if (!effects) return tl::unexpected(effects.error());
    auto state = std::make_unique<State>(State{std::move(*body), std::move(*effects), {}});
    for (std::uint32_t p = 0; p < game::players; ++p) {
        state->scenes.at(p).emplace(state->effects, state->body.effects, p);
        state->scenes.at(p)->add(state->body.figure);
    }
    return ReplayBody(std::move(state));
}

std::string ReplayBody::header() {
    std::string names = "tick,player";
    for (const auto* side : {"front", "back"}) {
        for (int row = 1; row <= 5; ++row)
            for (int column = 1; column <= 4; ++column) names += text(",", side, "_", row, "_", column);
    }
    return names + "\n";
}

void ReplayBody::follow(const game::Simulation& match, std::string& rows) {
    if (match.now() % tactile::frame_ticks != 0) return;
    for (std::size_t p = 0; p < game::players; ++p) {
        auto& scene = *state_->scenes.at(p);
        scene.take(match);
        const auto& frame = scene.frame(0);
        if (frame.is_silent()) continue;
        rows += text(match.now(), ",", p + 1);
        for (std::size_t cell = 0; cell < game::figure_cells; ++cell)
            rows += text(",", fixed(static_cast<double>(frame.amplitude.at(cell)), 4));
        rows += "\n";
    }
}

}  // namespace thaum::app
