// game/live/body_sound.h: the sounds of one match as both players feel them on their jackets. They are
// computed from the match, apart from the loudspeakers. So they are the same in a session and in `thaum
// replay --tactile`, at any loudness and without a sound device.
#pragma once
#include "game/senses/sound/sound_scene.h"
#include "game/senses/tactile/felt_sound.h"

namespace thaum::game::inline live {

/// Loads from assets/tactile/sound.toml the frequency bands in which sounds are felt. Computes the strength
/// over time (the course) of each sound of a bank in these bands. The error is one line.
Expected<FeltCourses> load_felt_courses(const audio::SoundBank& bank, const std::filesystem::path& assets);

class BodySound {
public:
    /// Keeps a reference to `courses` (strengths of the sounds over time), which must outlive this object.
    BodySound(MatchSounds sounds, const FeltCourses& courses) : scene_(std::move(sounds)), felt_(courses) {}

    /// Computes what was heard in the last eight ticks. Call this in every eighth tick only.
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
