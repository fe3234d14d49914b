#include "game/app/live_body.h"

#include <algorithm>
#include <cstdio>

namespace thaum::app {
namespace {

/// Number of the pad's layout in a scene, after the figure.
constexpr std::size_t pad_frame = 1;

}  // namespace

Expected<LiveBody> LiveBody::load(const std::filesystem::path& assets) {
    auto effects = tactile::load_effects(assets / "tactile" / "effects");
    if (!effects) return tl::unexpected(effects.error());
    auto figure = tactile::load_layout(assets / "tactile" / "layouts" / "abstract_4x5.toml");
    if (!figure) return tl::unexpected(figure.error());
    if (figure->actuators.size() != game::figure_cells)
        return fail("abstract_4x5.toml must have 40 actuators: the figure on the screen shows them");
    auto pad = tactile::load_layout(assets / "tactile" / "layouts" / "pad.toml");
    if (!pad) return tl::unexpected(pad.error());
    return LiveBody{std::move(*effects), std::move(*figure), std::move(*pad)};
}

void MatchBody::begin(const game::Simulation& match) {
    data_ = &match.data();
    for (auto& scene : scenes_) scene.reset();
    auto effects = game::match_effects(body_->effects, *match.data().presentation);
    if (!effects) {
        std::fprintf(stderr, "nothing is felt on the body: %s\n", effects.error().message.c_str());
        return;
    }
    effects_ = std::move(*effects);
    for (std::uint32_t p = 0; p < game::players; ++p) {
        scenes_.at(p).emplace(*effects_, body_->effects, p);
        scenes_.at(p)->add(body_->figure);
        scenes_.at(p)->add(body_->pad);
    }
}

void MatchBody::follow(const game::Simulation& match) {
    if (!body_ || match.now() % tactile::frame_ticks != 0) return;
    if (data_ != &match.data()) begin(match);
    now_ = match.now();
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (!scenes_.at(p)) continue;
        scenes_.at(p)->take(match);
        if (motors_.feels(p)) motors_.feel(p, scenes_.at(p)->frame(pad_frame));
        if (!scenes_.at(p)->frame(0).is_silent()) felt_at_.at(p) = now_;
    }
}

void MatchBody::show(game::Picture& picture) const {
    for (std::size_t p = 0; p < game::players; ++p) {
        if (!scenes_.at(p)) continue;
        auto& shown = picture.wizards.at(p);
        const auto& amplitude = scenes_.at(p)->frame(0).amplitude;
        std::copy_n(amplitude.begin(), game::figure_cells, shown.felt.begin());
        shown.since_felt_s = felt_at_.at(p) == 0 ? 1e6 : seconds(now_ - std::min(now_, felt_at_.at(p)));
    }
}

}  // namespace thaum::app
