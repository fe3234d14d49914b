#include "game/senses/senses.h"

namespace thaum::game::inline senses {

Expected<std::shared_ptr<const SenseData>> SenseData::load(const std::filesystem::path& assets,
                                                           audio::WithSamples samples) {
    auto bank = audio::load_sounds(assets / "sounds", samples);
    if (!bank) return bank.error();
    auto effects = tactile::load_effects(assets / "tactile" / "effects");
    if (!effects) return effects.error();
    auto figure = tactile::load_layout(assets / "tactile" / "layouts" / "abstract_4x5.toml");
    if (!figure) return figure.error();
    return std::make_shared<const SenseData>(
        SenseData{std::move(*bank), std::move(*effects), std::move(*figure)});
}

std::unique_ptr<Senses> Senses::create(std::shared_ptr<const SenseData> data, const Presentation& shown) {
    auto effects = match_effects(data->effects, shown);
    auto sounds = match_sounds(data->bank, shown);
    return std::make_unique<Senses>(std::move(data), std::move(sounds), std::move(effects));
}

Senses::Senses(std::shared_ptr<const SenseData> data, MatchSounds sounds, MatchEffects effects)
    : data_(std::move(data)),
      sounds_(std::move(sounds)),
      effects_(std::move(effects)),
      told_(told_by_sounds(sounds_, data_->bank)),
      sound_(sounds_) {
    for (std::uint32_t p = 0; p < players; ++p) {
        scenes_.at(p) = std::make_unique<TactileScene>(effects_, data_->effects, p);
        scenes_.at(p)->set_faders(scenes_.at(p)->add(data_->figure), figure_faders());
    }
}

std::size_t Senses::add(const tactile::Layout& layout) {
    std::size_t number = 0;
    for (auto& scene : scenes_) number = scene->add(layout);
    return number;
}

void Senses::follow(const Simulation& match) {
    constexpr std::array<std::uint32_t, players> both{0, 1};
    if (match.now() % audio::frame_ticks != 0) return;
    static_assert(audio::frame_ticks == tactile::frame_ticks);
    now_ = match.now();
    sound_.take(match, both, frame_);
    const bool plays = match.match().phase == Phase::playing && match.match().paused == 0;
    for (std::uint32_t p = 0; p < players; ++p) {
        auto& lines = lines_.at(p);
        lines.pass_frame();
        lines.follow(frame_, data_->bank, p);
        if (plays) hands_.at(p).take(match, p, lines);
        scenes_.at(p)->take(match);
        if (!scenes_.at(p)->frame(0).is_silent()) felt_at_.at(p) = now_;
        add_body_words(*scenes_.at(p), effects_, data_->effects, told_, lines);
    }
}

double Senses::since_felt_s(std::uint32_t player) const {
    return game::since_felt_s(now_, felt_at_.at(player));
}

}  // namespace thaum::game::inline senses
