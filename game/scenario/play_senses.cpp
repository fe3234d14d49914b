#include "game/scenario/play_senses.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "audio/analysis.h"
#include "audio/mixer.h"
#include "core/text.h"
#include "game/match/simulation.h"
#include "game/senses/senses.h"

namespace thaum::game::inline scenario {
namespace {

constexpr std::size_t max_mixed = 120 * audio::sample_rate;  // longest mixed sound that is kept (samples)

}  // namespace

struct PlaySenses::Inside {
    std::unique_ptr<Senses> senses;
    std::vector<std::string> names{"abstract_4x5"};  ///< names of the layouts, by number
    std::deque<tactile::Layout> layouts;  ///< layouts that the script asked for; the first has number 1
    std::optional<audio::Mixer> mixer;
    std::array<float, audio::block_values> block{};
    std::vector<float> mixed;
    /// signature of each sound, with which `nearest` compares; empty until `nearest` is called
    std::vector<audio::Signature> known;
};

PlaySenses::PlaySenses(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
PlaySenses::~PlaySenses() = default;

Expected<std::unique_ptr<PlaySenses>> PlaySenses::create(const std::filesystem::path& assets,
                                                         const Presentation& shown,
                                                         const std::vector<std::string>& layouts,
                                                         bool mixed) {
    auto data = SenseData::load(assets, mixed ? audio::WithSamples::yes : audio::WithSamples::no);
    if (!data) return data.error();
    if (!(*data)->bank.faulty.empty()) return (*data)->bank.faulty[0].fault;
    if (!(*data)->effects.faulty.empty()) return (*data)->effects.faulty[0].fault;
    auto out = std::make_unique<Inside>();
    out->senses = Senses::create(*data, shown);
    if (!out->senses->effects().missing.empty()) return fail(line_of(out->senses->effects().missing[0]));
    for (const auto& name : layouts) {
        auto layout = tactile::load_layout(assets / "tactile" / "layouts" / (name + ".toml"));
        if (!layout) return layout.error();
        out->names.push_back(name);
        out->senses->add(out->layouts.emplace_back(std::move(*layout)));
    }
    if (mixed) {
        auto mixer = audio::Mixer::create((*data)->bank, {});
        if (!mixer) return mixer.error();
        out->mixer.emplace(std::move(*mixer));
    }
    return std::unique_ptr<PlaySenses>(new PlaySenses(std::move(out)));
}

void PlaySenses::follow(const Simulation& match) {
    inside_->senses->follow(match);
    if (!inside_->mixer || match.now() % audio::frame_ticks != 0) return;
    inside_->mixer->play(inside_->senses->heard(), inside_->block);
    if (inside_->mixed.size() + audio::frame_samples > max_mixed) inside_->mixed.clear();
    for (std::size_t i = 0; i < inside_->block.size(); i += 2) inside_->mixed.push_back(inside_->block.at(i));
}

const audio::SoundBank& PlaySenses::bank() const { return inside_->senses->data().bank; }

std::span<const HeardLine> PlaySenses::lines(std::uint32_t player) const {
    return inside_->senses->lines(player);
}

const tactile::TactileFrame& PlaySenses::felt(std::uint32_t player, std::size_t layout) const {
    return inside_->senses->felt(player, layout);
}

const tactile::MixerCounts& PlaySenses::counts(std::uint32_t player, std::size_t layout) const {
    return inside_->senses->counts(player, layout);
}

std::vector<float> PlaySenses::take_mixed() { return std::exchange(inside_->mixed, {}); }

bool PlaySenses::mixes() const { return inside_->mixer.has_value(); }

std::optional<std::size_t> PlaySenses::layout(std::string_view name) const {
    const auto found = std::find(inside_->names.begin(), inside_->names.end(), name);
    if (found == inside_->names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - inside_->names.begin());
}

const tactile::Layout& PlaySenses::layout(std::size_t number) const {
    return number == 0 ? inside_->senses->data().figure : inside_->layouts.at(number - 1);
}

std::vector<float> PlaySenses::play_alone(std::uint32_t sound) {
    const auto& kind = inside_->senses->data().bank.sounds[sound];
    constexpr std::size_t tail = 4;  // silence after the sound (audio frames)
    audio::AudioFrame frame;
    const audio::Voice voice{.sound = sound, .key = 1, .position = {0, 0, -2}};
    if (!kind.loops) frame.begins.add(voice);
    std::vector<float> heard;
    inside_->mixer->silence();
    while (heard.size() < kind.samples.size() + tail * audio::frame_samples) {
        frame.lasts.count = 0;
        if (kind.loops) frame.lasts.add(voice);
        inside_->mixer->play(frame, inside_->block);
        frame.begins.count = 0;
        for (std::size_t i = 0; i < inside_->block.size(); i += 2) heard.push_back(inside_->block.at(i));
    }
    inside_->mixer->silence();
    return heard;
}

std::size_t PlaySenses::nearest(const std::vector<float>& samples) {
    const auto& sounds = inside_->senses->data().bank.sounds;
    for (std::size_t i = inside_->known.size(); i < sounds.size(); ++i)
        inside_->known.push_back(audio::signature_of(sounds[i].samples));
    const auto signature = audio::signature_of(samples);
    const auto is_nearer = [&](const audio::Signature& a, const audio::Signature& b) {
        return audio::distance(signature, a) < audio::distance(signature, b);
    };
    return static_cast<std::size_t>(
        std::min_element(inside_->known.begin(), inside_->known.end(), is_nearer) - inside_->known.begin());
}

}  // namespace thaum::game::inline scenario
