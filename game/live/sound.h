// game/live/sound.h: the sound of a live session: the bank of sounds, the loudspeakers, and what is heard of
// each match, as sound and in words.
//
// The main thread owns a LiveSound. The thread that plays a match or a replay makes a MatchSound for it.
// Without sounds or a sound device all goes on in silence, with one line that says why.
#pragma once
#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "audio/speakers.h"
#include "game/live/told_state.h"
#include "game/picture/picture.h"
#include "game/senses/felt_words.h"
#include "game/senses/sound/sound_scene.h"
#include "game/senses/tactile/felt_sound.h"
#include "game/settings/settings.h"

namespace thaum::game::inline live {

/// Sounds of a menu.
enum class MenuSound : std::uint8_t { none, move, choose, back, refused };
/// Names of the files of menu sounds in assets/sounds, in the order of MenuSound; empty: no sound.
inline constexpr std::array<std::string_view, 5> menu_sound_names{"", "menu_move", "menu_choose", "menu_back",
                                                                  "menu_refused"};

class LiveSound {
public:
    /// Makes all sounds and starts the loudspeakers' thread. Null after an
    /// error, which is printed in one line.
    static std::unique_ptr<LiveSound> start(const std::filesystem::path& assets, const Settings& settings);
    /// For tests: plays on `device` instead of the loudspeakers.
    LiveSound(audio::SoundBank bank, audio::Mixer mixer, std::unique_ptr<audio::SoundDevice> device,
              std::filesystem::path assets = {});

    const audio::SoundBank& bank() const { return bank_; }

    // Called by the main thread.
    void apply(const Settings& settings);
    void play(MenuSound sound);
    std::string status() const { return speakers_.status(); }
    /// Prints the loudspeakers' state when they stop working or work again.
    void tell_status();

    // Called by the thread of a match.
    /// Courses (strengths over time) of the sounds, for players who feel them; null while no player wants
    /// that.
    const FeltCourses* felt_courses() const { return courses_; }
    /// Whether anybody hears the match, or reads in words what is heard. Otherwise no audio frames (what is
    /// heard in eight ticks) need be made.
    bool is_wanted() const { return words_ || speakers_.plays(); }
    void hear(const audio::AudioFrame& frame) { speakers_.hear(frame); }

private:
    void make_courses();

    audio::SoundBank bank_;
    audio::Speakers speakers_;
    std::filesystem::path assets_{};  ///< folder of data files; empty: no sounds are felt
    std::unique_ptr<const FeltCourses> made_courses_{};
    /// the object in `made_courses_`, for the thread of a match
    std::atomic<const FeltCourses*> courses_{};
    bool tried_courses_ = false;
    std::atomic<bool> words_{};  ///< true: a player wants to read in words what is heard
    ToldState told_{};
};

/// The sounds of one match. The thread that plays the match owns it.
class MatchSound {
public:
    /// `sound`: null for silence. Then nothing is computed.
    explicit MatchSound(LiveSound* sound) : sound_(sound) {}
    /// Ends those sounds of the match that would go on, such as hums and music.
    ~MatchSound();
    MatchSound(const MatchSound&) = delete;
    MatchSound& operator=(const MatchSound&) = delete;

    /// Sets whose ears hear the match: the first player's, the second's, or both. If neither is true, both
    /// hear it.
    void listen(bool first, bool second);
    /// Follows the match after a tick; starts anew with another match or changed data.
    void follow(const Simulation& match);
    /// Plays the sound of one second of the countdown before the match.
    void count_down();
    /// Forgets the words on what was heard, after a jump to another time in a replay.
    void forget() {
        heard_ = {};
        hands_ = {};
    }
    /// Words on what one player hears. MatchBody adds what the player feels.
    HeardLines& words(std::uint32_t player) { return heard_.at(player); }
    /// Events of this match, and effects on the body, that captions of sounds describe already. No other
    /// words are shown for them.
    const ToldBySounds& told() const { return told_; }
    /// Adds to a picture the words on what players hear and feel.
    void show(Picture& picture) const;

private:
    void begin(const Simulation& match);
    void hear(const Simulation& match);

    LiveSound* sound_;
    std::optional<SoundScene> scene_{};
    const MatchData* data_{};  ///< data of the match that is followed
    std::array<std::uint32_t, players> listening_{0, 1};
    std::size_t listeners_ = 2;
    audio::AudioFrame frame_{};
    ToldBySounds told_{};
    std::array<HeardLines, players> heard_{};  ///< words on what each player hears at present
    std::array<HandWords, players> hands_{};   ///< finds words on what each player's hand feels
};

/// The part of the settings that the sound mixer uses.
audio::MixSettings mix_settings(const Settings& settings);

}  // namespace thaum::game::inline live
