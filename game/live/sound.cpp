#include "game/live/sound.h"

#include <algorithm>
#include <utility>

#include "audio/synth.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/live/body_sound.h"

namespace thaum::game::inline live {
namespace {

std::unique_ptr<LiveSound> silent(const Error& error) {
    tell_user(text("no sound: ", error.message));
    return nullptr;
}

}  // namespace

audio::MixSettings mix_settings(const Settings& settings) {
    return {.master = settings.sound_master,
            .effects = settings.sound_effects,
            .music = settings.sound_music,
            .interface = settings.sound_interface,
            .headphones = settings.headphones,
            .ears = settings.ears_apart ? audio::Ears::left_right : audio::Ears::shared};
}

std::unique_ptr<LiveSound> LiveSound::start(const std::filesystem::path& assets, const Settings& settings) {
    auto bank = audio::load_sounds(assets / "sounds");
    if (!bank) return silent(bank.error());
    for (const auto& sound : bank->faulty)
        tell_user(text("the sound '", sound.name, "' is silent: ", sound.fault.message));
    auto mixer = audio::Mixer::create(*bank, mix_settings(settings));
    if (!mixer) return silent(mixer.error());
    auto sound =
        std::make_unique<LiveSound>(std::move(*bank), std::move(*mixer), audio::openal_device(), assets);
    sound->apply(settings);
    return sound;
}

LiveSound::LiveSound(audio::SoundBank bank, audio::Mixer mixer, std::unique_ptr<audio::SoundDevice> device,
                     std::filesystem::path assets)
    : bank_(std::move(bank)), speakers_(std::move(mixer), std::move(device)), assets_(std::move(assets)) {}

/// Computes the courses (strengths over time) of all sounds, once. A fault is printed, and then no sound is
/// felt.
void LiveSound::make_courses() {
    if (std::exchange(tried_courses_, true) || assets_.empty()) return;
    auto courses = load_felt_courses(bank_, assets_);
    if (!courses) {
        tell_user(text("no sound on the jacket: ", courses.error().message));
        return;
    }
    made_courses_ = std::make_unique<const FeltCourses>(std::move(*courses));
    courses_ = made_courses_.get();
}

void LiveSound::apply(const Settings& settings) {
    speakers_.set(mix_settings(settings));
    words_ = std::any_of(settings.players.begin(), settings.players.end(),
                         [](const auto& player) { return player.heard != HeardWish::none; });
    if (std::any_of(settings.players.begin(), settings.players.end(),
                    [](const auto& player) { return player.jacket_sound > 0; }))
        make_courses();
}

void LiveSound::play(MenuSound sound) {
    if (const auto number = bank_.find(menu_sound_names.at(static_cast<std::size_t>(sound))))
        speakers_.hear(audio::Voice{.sound = *number, .at_ear = true});
}

void LiveSound::tell_status() { told_.tell("", speakers_); }

MatchSound::~MatchSound() {
    if (sound_ != nullptr) sound_->hear(audio::AudioFrame{});
}

void MatchSound::listen(bool first, bool second) {
    listeners_ = 0;
    if (first) listening_.at(listeners_++) = 0;
    if (second) listening_.at(listeners_++) = 1;
    if (listeners_ == 0) {  // two bots: whoever looks on hears with both players' ears
        listening_ = {0, 1};
        listeners_ = 2;
    }
}

/// Makes the object that turns the match's state and events into sounds. Prints the sounds that are missing.
void MatchSound::begin(const Simulation& match) {
    auto sounds = match_sounds(sound_->bank(), *match.data().presentation);
    for (const auto& line : sounds.missing) tell_user(text("a sound is missing: ", line_of(line)));
    told_ = told_by_sounds(sounds, sound_->bank());
    scene_.emplace(std::move(sounds));
}

void MatchSound::hear(const Simulation& match) {
    if (!scene_) begin(match);
    scene_->take(match, {listening_.data(), listeners_}, frame_);
    sound_->hear(frame_);
    for (std::uint32_t i = 0; i < listeners_; ++i)
        heard_.at(listening_.at(i)).follow(frame_, sound_->bank(), i);
}

void MatchSound::follow(const Simulation& match) {
    if (match.now() % audio::frame_ticks != 0) return;
    if (data_ != &match.data()) {
        data_ = &match.data();
        scene_.reset();
        forget();  // the words refer to strings of the old data, so they are dropped
    }
    for (auto& lines : heard_) lines.pass_frame();
    if (sound_ != nullptr && !sound_->is_wanted()) return;
    if (sound_ != nullptr) hear(match);
    if (match.match().phase != Phase::playing || match.match().paused != 0) return;
    for (std::uint32_t p = 0; p < players; ++p) hands_.at(p).take(match, p, heard_.at(p));
}

void MatchSound::count_down() {
    if (sound_ == nullptr) return;
    audio::AudioFrame frame;
    if (const auto number = sound_->bank().find("count_tick"))
        frame.begins.add({.sound = *number, .at_ear = true});
    sound_->hear(frame);
}

void MatchSound::show(Picture& picture) const {
    for (std::size_t p = 0; p < players; ++p) {
        auto& shown = picture.wizards.at(p);
        const auto lines = heard_.at(p).lines();
        shown.senses.heard_lines =
            static_cast<std::uint32_t>(std::min(lines.size(), shown.senses.heard.size()));
        std::copy_n(lines.begin(), shown.senses.heard_lines, shown.senses.heard.begin());
    }
}

}  // namespace thaum::game::inline live
