#include "game/live/body_sound.h"

namespace thaum::game::inline live {

Expected<FeltCourses> load_felt_courses(const audio::SoundBank& bank, const std::filesystem::path& assets) {
    const auto bands = load_felt_bands(assets / "tactile" / "sound.toml");
    if (!bands) return bands.error();
    return felt_courses(bank, *bands);
}

void BodySound::take(const Simulation& match) {
    // The two listeners are the two players in the same order, so a listener's index is the player's number.
    constexpr std::array<std::uint32_t, players> both{0, 1};
    if (!follower_.goes_on(match)) felt_.stop();
    follower_.look(match);
    scene_.take(match, both, frame_);
    felt_.follow(frame_);
}

}  // namespace thaum::game::inline live
