#include "game/app/replay_sound.h"

#include "audio/synth.h"
#include "core/tell_user.h"
#include "core/text.h"

namespace thaum::game::inline app {

Expected<ReplaySound> ReplaySound::create(const std::filesystem::path& file,
                                          std::optional<std::uint32_t> ears, const MatchData& data,
                                          const std::filesystem::path& assets) {
    const auto bank = audio::load_sounds(assets / "sounds");
    if (!bank) return bank.error();
    auto sounds = match_sounds(*bank, *data.presentation);
    for (const auto& sound : bank->faulty)
        tell_user(text("the sound '", sound.name, "' is silent: ", sound.fault.message));
    for (const auto& line : sounds.missing) tell_user(text("a sound is missing: ", line_of(line)));
    auto mixer = audio::Mixer::create(*bank, {});
    if (!mixer) return mixer.error();
    auto writer = audio::WavWriter::create(file, audio::WavFormat::whole_16);
    if (!writer) return writer.error();
    return ReplaySound(std::move(*writer), std::move(*mixer), SoundScene(std::move(sounds)), ears);
}

void ReplaySound::follow(const Simulation& match) {
    if (match.now() % audio::frame_ticks != 0 || match.now() == 0) return;
    constexpr std::array<std::uint32_t, players> both{0, 1};
    const std::array<std::uint32_t, 1> one{ears_.value_or(0)};
    scene_.take(match, ears_ ? std::span<const std::uint32_t>(one) : both, frame_);
    mixer_.play(frame_, block_);
    file_.write(block_);
}

Expected<void> ReplaySound::close() {
    // Number of blocks of sound (8 ms each) written after the replay's end: 1.5 s, the length of the longest
    // sound.
    constexpr int tail = 190;
    frame_.begins.count = frame_.lasts.count = 0;
    for (int i = 0; i < tail; ++i) {
        mixer_.play(frame_, block_);
        file_.write(block_);
    }
    return file_.close();
}

}  // namespace thaum::game::inline app
