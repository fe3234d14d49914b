#include "game/app/replay_body.h"

#include "game/app/felt_rows.h"

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

void ReplayBody::follow(const game::Simulation& match, std::string& rows) {
    if (match.now() % tactile::frame_ticks != 0) return;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        auto& scene = *state_->scenes.at(p);
        scene.take(match);
        if (!scene.frame(0).is_silent()) append_felt(rows, p, scene.frame(0));
    }
}

}  // namespace thaum::app
