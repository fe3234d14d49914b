#include "game/app/live_body.h"

#include <algorithm>
#include <cstdio>

namespace thaum::app {
namespace {

/// Numbers of layouts in a scene, after the figure.
constexpr std::size_t pad_frame = 1, x40_frame = 2, x16_frame = 3;

Expected<tactile::Layout> layout_of(const std::filesystem::path& assets, const char* file) {
    return tactile::load_layout(assets / "tactile" / "layouts" / file);
}

}  // namespace

Expected<LiveBody> LiveBody::load(const std::filesystem::path& assets) {
    auto effects = tactile::load_effects(assets / "tactile" / "effects");
    if (!effects) return tl::unexpected(effects.error());
    auto figure = layout_of(assets, "abstract_4x5.toml"), pad = layout_of(assets, "pad.toml"),
         x40 = layout_of(assets, "x40.toml"), x16 = layout_of(assets, "x16.toml");
    for (const auto* layout : {&figure, &pad, &x40, &x16})
        if (!*layout) return tl::unexpected(layout->error());
    if (figure->actuators.size() != game::figure_cells)
        return fail("abstract_4x5.toml must have 40 actuators: the figure on the screen shows them");
    return LiveBody{std::move(*effects), std::move(*figure), std::move(*pad), std::move(*x40),
                    std::move(*x16)};
}

const tactile::Layout* LiveBody::layout_named(std::string_view name) const {
    return name == "x40" ? &x40 : name == "x16" ? &x16 : nullptr;
}

std::vector<tactile::Purpose> LiveBody::purposes() const {
    std::vector<tactile::Purpose> found;
    for (std::size_t i = 0; i < tactile::purpose_count; ++i) {
        const auto purpose = static_cast<tactile::Purpose>(i);
        const auto has = [&](const tactile::Effect& effect) { return effect.purpose == purpose; };
        if (std::any_of(effects.effects.begin(), effects.effects.end(), has)) found.push_back(purpose);
    }
    return found;
}

void MatchBody::begin(const game::Simulation& match) {
    data_ = &match.data();
    for (auto& scene : scenes_) scene.reset();
    faders_ = {};
    auto effects = game::match_effects(body_->effects, *match.data().presentation);
    if (!effects) {
        std::fprintf(stderr, "nothing is felt on the body: %s\n", effects.error().message.c_str());
        return;
    }
    effects_ = std::move(*effects);
    for (std::uint32_t p = 0; p < game::players; ++p) {
        scenes_.at(p).emplace(*effects_, body_->effects, p);
        const auto figure = scenes_.at(p)->add(body_->figure);
        scenes_.at(p)->add(body_->pad);
        scenes_.at(p)->add(body_->x40);
        scenes_.at(p)->add(body_->x16);
        // The figure shows what comes from outside. The own shots would hide it.
        // The player's own faders are for motors.
        tactile::Faders shown;
        shown.of(tactile::Purpose::recoil) = 0;
        scenes_.at(p)->set_faders(figure, shown);
    }
}

/// Gives the player's faders to motors and jackets if they have changed.
void MatchBody::take_faders(std::uint32_t player) {
    const auto faders = motors_.faders(player);
    if (faders_.at(player) == faders) return;
    faders_.at(player) = faders;
    for (const auto layout : {pad_frame, x40_frame, x16_frame})
        scenes_.at(player)->set_faders(layout, faders);
}

/// Makes the frames of the player's outputs, and of no others, and passes them on.
void MatchBody::feel(std::uint32_t player, const game::Simulation& match) {
    auto& scene = *scenes_.at(player);
    const bool pad = motors_.feels(player);
    const auto jacket = motors_.jacket_layout(player);
    const bool x40 = jacket == "x40", x16 = jacket == "x16";
    take_faders(player);
    scene.set_used(pad_frame, pad);
    scene.set_used(x40_frame, x40);
    scene.set_used(x16_frame, x16);
    scene.take(match);
    if (pad) motors_.feel(player, scene.frame(pad_frame));
    if (x40 || x16) motors_.feel_jacket(player, scene.frame(x40 ? x40_frame : x16_frame));
}

void MatchBody::follow(const game::Simulation& match, MatchSound& sound) {
    if (!body_ || match.now() % tactile::frame_ticks != 0) return;
    if (data_ != &match.data()) begin(match);
    now_ = match.now();
    still_ = false;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (!scenes_.at(p)) continue;
        feel(p, match);
        game::add_body_words(*scenes_.at(p), *effects_, body_->effects, sound.told(), sound.words(p));
        if (!scenes_.at(p)->frame(0).is_silent()) felt_at_.at(p) = now_;
    }
}

void MatchBody::forget() {
    felt_at_ = {};
    still_ = true;
}

void MatchBody::show(game::Picture& picture) const {
    for (std::size_t p = 0; p < game::players; ++p) {
        if (!scenes_.at(p)) continue;
        auto& shown = picture.wizards.at(p);
        const auto& amplitude = scenes_.at(p)->frame(0).amplitude;
        shown.felt.fill(0);
        if (!still_) std::copy_n(amplitude.begin(), game::figure_cells, shown.felt.begin());
        shown.since_felt_s = felt_at_.at(p) == 0 ? 1e6 : seconds(now_ - std::min(now_, felt_at_.at(p)));
    }
}

}  // namespace thaum::app
