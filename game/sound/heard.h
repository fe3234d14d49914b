// game/sound/heard.h: sounds in words, for players who do not hear them: "step, behind". The words are those of the
// sounds that a frame begins or keeps up, so nothing is heard that has no words.
#pragma once
#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <string_view>

#include "audio/frame.h"

namespace thaum::game {

/// The sounds that a player wants in words.
enum class HeardWish : std::uint8_t { none, important, all };

/// Side from which a sound comes. `here`: from the listener, or from no place.
enum class HeardFrom : std::uint8_t { here, ahead, right, behind, left, above, below };
inline constexpr std::array<std::string_view, 7> heard_from_words{"",     "ahead", "right", "behind",
                                                                  "left", "above", "below"};

/// A sound in words. Two voices of one sound from one side are one line.
struct HeardLine {
    std::string_view words;  ///< caption of the sound; it belongs to the bank
    HeardFrom from{};
    bool important{};
    double age_s{};  ///< time since the sound was last heard
};

/// Time for which a line stays after its sound (s).
inline constexpr double heard_seconds = 1.6;

/// Lines of one listener, the oldest first.
class HeardLines {
public:
    /// Takes the voices of one frame that this listener hears.
    void follow(const audio::AudioFrame& frame, const audio::SoundBank& bank, std::uint32_t listener);
    std::span<const HeardLine> lines() const { return {lines_.data(), count_}; }

private:
    void hear(const HeardLine& line);

    /// Whether the caption of a lasting voice is to be told. That of music is told once, when it begins.
    bool tells(const audio::SoundBank& bank, const audio::Voice& voice, bool loud);

    std::array<HeardLine, 8> lines_{};
    std::bitset<256> music_{};  ///< by number of the sound: music that is heard
    std::size_t count_ = 0;
};

/// Side from which a listener hears a place.
HeardFrom side_of(const audio::Listener& listener, vec3 place);

}  // namespace thaum::game
