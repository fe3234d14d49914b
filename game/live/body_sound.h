// game/live/body_sound.h: the sounds of one match as both players feel them on their jackets. They are
// computed from the match, apart from the loudspeakers. So they are the same in a session and in `thaum
// replay --tactile`, at any loudness and without a sound device.
#pragma once
#include "game/senses/sound/sound_scene.h"
#include "game/senses/tactile/felt_sound.h"

namespace thaum::game::inline live {

/// The bands of assets/tactile/sound.toml, and the courses of a bank's sounds. The error is one line.
Expected<FeltCourses> load_felt_courses(const audio::SoundBank& bank, const std::filesystem::path& assets);

class BodySound {
public:
    /// Keeps the reference to the courses.
    BodySound(MatchSounds sounds, const FeltCourses& courses) : scene_(std::move(sounds)), felt_(courses) {}

    /// Takes the eight ticks that have passed, at every eighth tick.
    void take(const Simulation& match);
    BandStrengths strengths(std::uint32_t player, const FeltSoundWish& wish) const {
        return felt_.strengths(player, wish);
    }

private:
    SoundScene scene_;
    FeltSound felt_;
    MatchFollower follower_{};
    audio::AudioFrame frame_{};
};

}  // namespace thaum::game::inline live
