#include "game/live/body_trial.h"

#include <algorithm>

namespace thaum::game::inline live {
namespace {

constexpr std::int64_t trial_tick_ns = 1'000'000;
constexpr Tick longest_trial = ticks(5.0);

}  // namespace

std::unique_ptr<tactile::TactileMixer> BodyTrial::mixer_for(const tactile::Layout& layout,
                                                            std::uint32_t effect,
                                                            const tactile::Faders& faders) const {
    auto mixer = std::make_unique<tactile::TactileMixer>(layout, body_.effects);
    mixer->set_faders(faders);
    mixer->start(effect, tactile::Where::own(), 1, 0);
    return mixer;
}

bool BodyTrial::start(std::uint32_t player, tactile::Purpose purpose, const tactile::Faders& faders,
                      std::int64_t now_ns) {
    const auto& effects = body_.effects.effects;
    const auto found = std::find_if(effects.begin(), effects.end(),
                                    [&](const tactile::Effect& effect) { return effect.purpose == purpose; });
    if (found == effects.end()) return false;
    const auto effect = static_cast<std::uint32_t>(found - effects.begin());
    Playing next{.player = player, .began_ns = now_ns};
    next.figure = mixer_for(body_.figure, effect, faders);
    if (outputs_.feels(player)) next.motors = mixer_for(body_.pad, effect, faders);
    if (const auto* layout = body_.jacket_of(player, outputs_.jacket_layout(player)))
        next.jacket = mixer_for(*layout, effect, faders);
    playing_ = std::move(next);
    step(now_ns);
    return true;
}

void BodyTrial::step(std::int64_t now_ns) {
    if (!playing_) return;
    auto& p = *playing_;
    const auto since = static_cast<Tick>(std::max<std::int64_t>(0, now_ns - p.began_ns) / trial_tick_ns);
    const Tick due = since / tactile::frame_ticks * tactile::frame_ticks;
    if (p.mixed && due <= *p.mixed) return;
    p.mixed = due;
    const auto& shown = p.figure->mix(due).amplitude;
    std::copy_n(shown.begin(), figure_.size(), figure_.begin());
    if (p.motors) outputs_.try_out(p.player, p.motors->mix(due));
    if (p.jacket) outputs_.try_out_jacket(p.player, p.jacket->mix(due));
    if (p.figure->playing() > 0 && due < longest_trial) return;
    playing_.reset();
    figure_.fill(0);
}

}  // namespace thaum::game::inline live
