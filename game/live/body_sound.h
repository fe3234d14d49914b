// game/live/body_sound.h: the sounds of one match as both players feel them on their jackets. They are
// computed from the match, apart from the loudspeakers. So they are the same in a session and in `thaum
// replay --tactile`, at any loudness and without a sound device.
#pragma once
#include "game/senses/sound/sound_scene.h"
#include "game/senses/tactile/felt_sound.h"

namespace thaum::game::inline live {

/// Loads the frequency bands of assets/tactile/sound.toml and computes the courses (strength over time in
/// each band) of the bank's sounds. The error is one line.
Expected<game::FeltCourses> load_felt_courses(const audio::SoundBank& bank,
                                              const std::filesystem::path& assets);

class BodySound {
public:
    /// `courses` must outlive this object.
    BodySound(game::MatchSounds sounds, const game::FeltCourses& courses)
        : scene_(std::move(sounds)), felt_(courses) {}

    /// Follows the match. Call it at every eighth tick: it takes the eight ticks that have passed.
    void take(const game::Simulation& match);
    game::BandStrengths strengths(std::uint32_t player, const game::FeltSoundWish& wish) const {
        return felt_.strengths(player, wish);
    }

private:
    game::SoundScene scene_;
    game::FeltSound felt_;
    game::MatchFollower follower_{};
    audio::AudioFrame frame_{};
};

}  // namespace thaum::game::inline live
