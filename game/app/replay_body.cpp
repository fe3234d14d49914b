#include "game/app/replay_body.h"

#include "audio/synth.h"
#include "game/jackets/felt_rows.h"

namespace thaum::game::inline app {

Expected<void> ReplayBody::add_sound(State& state, const MatchData& data,
                                     const std::filesystem::path& assets) {
    const auto bank = audio::load_sounds(assets / "sounds");
    if (!bank) return bank.error();
    auto courses = load_felt_courses(*bank, assets);
    if (!courses) return courses.error();
    state.courses.emplace(std::move(*courses));
    state.sound.emplace(match_sounds(*bank, *data.presentation), *state.courses);
    for (auto& scene : state.scenes) scene->set_hears(0, true);
    return {};
}

Expected<ReplayBody> ReplayBody::create(const MatchData& data, const std::filesystem::path& assets,
                                        std::optional<FeltGroups> sounds) {
    auto body = LiveBody::load(assets);
    if (!body) return body.error();
    if (!body->faults.empty()) return fail(body->faults[0]);
    auto effects = match_effects(body->effects, *data.presentation);
    if (!effects.missing.empty()) return fail(line_of(effects.missing[0]));
    auto state = std::make_unique<State>(State{std::move(*body), std::move(effects), {}, {}, {}, {}});
    for (std::uint32_t p = 0; p < players; ++p) {
        state->scenes.at(p).emplace(state->effects, state->body.effects, p);
        state->scenes.at(p)->add(state->body.figure);
    }
    if (sounds) {
        state->wish = {1, *sounds};
        if (auto added = add_sound(*state, data, assets); !added) return added.error();
    }
    return ReplayBody(std::move(state));
}

void ReplayBody::follow(const Simulation& match, std::string& rows) {
    if (match.now() % tactile::frame_ticks != 0) return;
    // At tick 0 no sound has been computed: as in a live match, the first sound is that of the first eight
    // ticks.
    if (state_->sound && match.now() != 0) state_->sound->take(match);
    for (std::uint32_t p = 0; p < players; ++p) {
        auto& scene = *state_->scenes.at(p);
        if (state_->sound) scene.set_sound(state_->sound->strengths(p, state_->wish));
        scene.take(match);
        if (!scene.frame(0).is_silent()) append_felt(rows, p, scene.frame(0));
    }
}

}  // namespace thaum::game::inline app
