#include "game/scenario/play_senses.h"

#include <algorithm>

#include "core/text.h"

namespace thaum::game {
namespace {

constexpr std::size_t most_mixed = 120 * audio::sample_rate;  // samples

}  // namespace

Expected<std::unique_ptr<PlaySenses>> PlaySenses::create(const std::filesystem::path& assets,
                                                         const Presentation& shown,
                                                         const std::vector<std::string>& layouts,
                                                         bool mixed) {
    auto data = SenseData::load(assets, mixed ? audio::WithSamples::yes : audio::WithSamples::no);
    if (!data) return tl::unexpected(data.error());
    if (!(*data)->bank.faulty.empty()) return fail((*data)->bank.faulty[0].reason);
    auto senses = Senses::create(*data, shown);
    if (!senses) return tl::unexpected(senses.error());
    auto out = std::make_unique<PlaySenses>();
    out->senses_ = std::move(*senses);
    for (const auto& name : layouts) {
        auto layout = tactile::load_layout(assets / "tactile" / "layouts" / (name + ".toml"));
        if (!layout) return tl::unexpected(layout.error());
        out->names_.push_back(name);
        out->senses_->add(out->layouts_.emplace_back(std::move(*layout)));
    }
    if (mixed) {
        auto mixer = audio::Mixer::create((*data)->bank, {});
        if (!mixer) return tl::unexpected(mixer.error());
        out->mixer_.emplace(std::move(*mixer));
    }
    return out;
}

void PlaySenses::follow(const Simulation& match) {
    senses_->follow(match);
    if (!mixer_ || match.now() % audio::frame_ticks != 0) return;
    mixer_->play(senses_->heard(), block_);
    if (mixed_.size() + audio::frame_samples > most_mixed) mixed_.clear();
    for (std::size_t i = 0; i < block_.size(); i += 2) mixed_.push_back(block_.at(i));
}

std::optional<std::size_t> PlaySenses::layout(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
}

const tactile::Layout& PlaySenses::layout(std::size_t number) const {
    return number == 0 ? senses_->data().figure : layouts_.at(number - 1);
}

std::vector<float> PlaySenses::play_alone(std::uint32_t sound) {
    const auto& kind = senses_->data().bank.sounds[sound];
    constexpr std::size_t tail = 4;  // frames
    audio::AudioFrame frame;
    const audio::Voice voice{.sound = sound, .key = 1, .position = {0, 0, -2}};
    if (!kind.loops) frame.begins.add(voice);
    std::vector<float> heard;
    mixer_->silence();
    while (heard.size() < kind.samples.size() + tail * audio::frame_samples) {
        frame.lasts.count = 0;
        if (kind.loops) frame.lasts.add(voice);
        mixer_->play(frame, block_);
        frame.begins.count = 0;
        for (std::size_t i = 0; i < block_.size(); i += 2) heard.push_back(block_.at(i));
    }
    mixer_->silence();
    return heard;
}

std::size_t PlaySenses::nearest(const std::vector<float>& samples) {
    const auto& sounds = senses_->data().bank.sounds;
    for (std::size_t i = known_.size(); i < sounds.size(); ++i)
        known_.push_back(audio::signature_of(sounds[i].samples));
    const auto signature = audio::signature_of(samples);
    const auto is_nearer = [&](const audio::Signature& a, const audio::Signature& b) {
        return audio::distance(signature, a) < audio::distance(signature, b);
    };
    return static_cast<std::size_t>(std::min_element(known_.begin(), known_.end(), is_nearer) -
                                    known_.begin());
}

}  // namespace thaum::game
