#include "game/live/body.h"

#include <algorithm>

#include "core/tell_user.h"
#include "core/text.h"

namespace thaum::game::inline live {
namespace {

/// Indices of the layouts (arrangements of motors or of cells) in a player's TactileScene.
constexpr std::size_t figure_frame = 0, pad_frame = 1, first_jacket_frame = 2;

/// Reads a layout, which must have `motors` actuators (0: any number). A faulty layout is returned empty,
/// with lines about it added to `faults`.
tactile::Layout layout_of(const std::filesystem::path& assets, std::string_view name, std::size_t motors,
                          std::vector<std::string>& faults) {
    const auto path = assets / "tactile" / "layouts" / text(name, ".toml");
    auto layout = tactile::load_layout(path);
    if (layout && (motors == 0 || layout->actuators.size() == motors)) return std::move(*layout);
    const auto lines = layout ? std::vector{text(path.string(), ": must have ", motors, " actuators, has ",
                                                 layout->actuators.size())}
                              : lines_of(layout.error());
    faults.insert(faults.end(), lines.begin(), lines.end());
    return {};
}

}  // namespace

Expected<LiveBody> LiveBody::load(const std::filesystem::path& assets) {
    auto effects = tactile::load_effects(assets / "tactile" / "effects");
    if (!effects) return effects.error();
    LiveBody body{.effects = std::move(*effects), .figure = {}, .pad = {}};
    for (const auto& effect : body.effects.faulty) {
        const auto lines = lines_of(effect.fault);
        body.faults.insert(body.faults.end(), lines.begin(), lines.end());
    }
    body.figure = layout_of(assets, figure_layout.name, 0, body.faults);
    body.pad = layout_of(assets, "pad", 0, body.faults);
    for (const auto& [name, motors] : jacket_layouts())
        body.jackets.push_back({name, layout_of(assets, name, motors, body.faults)});
    return body;
}

const tactile::Layout* LiveBody::jacket_of(std::uint32_t player, std::string_view name) const {
    const auto usual = std::ranges::find(jackets, name, &Worn::name);
    if (usual != jackets.end()) return &usual->layout;
    const auto& written = own.at(player);
    return written && name == own_layout.name ? &*written : nullptr;
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

void MatchBody::begin(const Simulation& match) {
    data_ = &match.data();
    felt_sound_.reset();
    for (auto& scene : scenes_) scene.reset();
    faders_ = {};
    effects_ = match_effects(body_->effects, *match.data().presentation);
    for (const auto& line : effects_->missing) tell_user(text("an effect is missing: ", line_of(line)));
    for (std::uint32_t p = 0; p < players; ++p) {
        scenes_.at(p).emplace(*effects_, body_->effects, p);
        const auto figure = scenes_.at(p)->add(body_->figure);
        scenes_.at(p)->add(body_->pad);
        for (const auto& jacket : body_->jackets)
            scenes_.at(p)->set_hears(scenes_.at(p)->add(jacket.layout), true);
        if (const auto& own = body_->own.at(p)) scenes_.at(p)->set_hears(scenes_.at(p)->add(*own), true);
        // The picture of the body has fixed strengths of its own. The strengths (faders) that the player has
        // set are for motors and jacket only.
        scenes_.at(p)->set_faders(figure, figure_faders());
    }
}

/// Passes the strengths that the player has set (faders) on to motors and jackets if they have changed.
void MatchBody::take_faders(std::uint32_t player) {
    const auto faders = motors_.faders(player);
    if (faders_.at(player) == faders) return;
    faders_.at(player) = faders;
    scenes_.at(player)->set_faders(pad_frame, faders);
    for (std::size_t i = 0; i < jackets_of(player); ++i)
        scenes_.at(player)->set_faders(first_jacket_frame + i, faders);
}

/// Whether a player wants to feel sounds on a jacket. True also while the jacket is lost, so that the sounds
/// are right as soon as it is back.
bool MatchBody::hears(std::uint32_t player) const {
    return motors_.felt_sound(player).strength > 0 && motors_.has_jacket(player);
}

/// Computes the sounds of the match for the players who feel them on a jacket. If no player does, computes
/// nothing.
void MatchBody::hear(const Simulation& match) {
    const auto* courses = sound_ != nullptr && (hears(0) || hears(1)) ? sound_->felt_courses() : nullptr;
    if (courses == nullptr) return felt_sound_.reset();
    if (!felt_sound_) felt_sound_.emplace(match_sounds(sound_->bank(), *match.data().presentation), *courses);
    felt_sound_->take(match);
}

/// Number of jacket layouts in a player's TactileScene: the shipped ones, then the player's own if there is
/// one.
std::size_t MatchBody::jackets_of(std::uint32_t player) const {
    return body_->jackets.size() + (body_->own.at(player) ? 1 : 0);
}

/// Name of the layout with index `number` among the jacket layouts of a player's TactileScene.
std::string_view MatchBody::name_of_jacket(std::size_t number) const {
    return number < body_->jackets.size() ? body_->jackets.at(number).name : own_layout.name;
}

/// Makes the frames (strengths of all motors) for the outputs that the player has at present, and passes them
/// on.
void MatchBody::feel(std::uint32_t player, const Simulation& match) {
    auto& scene = *scenes_.at(player);
    const bool pad = motors_.feels(player);
    const auto jacket = motors_.jacket_layout(player);
    take_faders(player);
    scene.set_used(figure_frame, motors_.shows_figure(player));
    scene.set_used(pad_frame, pad);
    scene.set_sound(felt_sound_ && hears(player) ? felt_sound_->strengths(player, motors_.felt_sound(player))
                                                 : BandStrengths{});
    for (std::size_t i = 0; i < jackets_of(player); ++i)
        scene.set_used(first_jacket_frame + i, jacket == name_of_jacket(i));
    scene.take(match);
    if (pad) motors_.feel(player, scene.frame(pad_frame));
    for (std::size_t i = 0; i < jackets_of(player); ++i)
        if (jacket == name_of_jacket(i)) motors_.feel_jacket(player, scene.frame(first_jacket_frame + i));
}

void MatchBody::follow(const Simulation& match, MatchSound& sound) {
    if (!body_ || match.now() % tactile::frame_ticks != 0) return;
    if (data_ != &match.data()) begin(match);
    now_ = match.now();
    still_ = false;
    hear(match);
    for (std::uint32_t p = 0; p < players; ++p) {
        if (!scenes_.at(p)) continue;
        feel(p, match);
        add_body_words(*scenes_.at(p), *effects_, body_->effects, sound.told(), sound.words(p));
        if (!scenes_.at(p)->frame(figure_frame).is_silent()) felt_at_.at(p) = now_;
    }
}

void MatchBody::forget() {
    felt_at_ = {};
    still_ = true;
}

void MatchBody::show(Picture& picture) const {
    for (std::size_t p = 0; p < players; ++p) {
        if (!scenes_.at(p)) continue;
        auto& shown = picture.wizards.at(p);
        const auto& amplitude = scenes_.at(p)->frame(figure_frame).amplitude;
        shown.senses.felt.fill(0);
        if (!still_) std::copy_n(amplitude.begin(), figure_cells, shown.senses.felt.begin());
        shown.senses.since_felt_s = since_felt_s(now_, felt_at_.at(p));
    }
}

}  // namespace thaum::game::inline live
