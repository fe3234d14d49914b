// game/senses/sound/heard.h: captions of what is heard and felt, for players who do not hear or feel
// it: "step, behind", "weight pulls down". Each audible sound that has a caption shows it when the
// sound starts and while it lasts (music only when it starts), so none is missed. Other code in
// game/senses adds what hand and body feel.
#pragma once
#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "audio/frame.h"

namespace thaum::game::inline senses {

/// Captions that a player has chosen to see.
enum class HeardWish : std::uint8_t { none, important, all };

/// Side from which a sound comes. `here`: from the listener, or from no place.
enum class HeardFrom : std::uint8_t { here, ahead, right, behind, left, above, below };
inline constexpr std::array<std::string_view, 7> heard_from_words{"",     "ahead", "right", "behind",
                                                                  "left", "above", "below"};

/// Words for the side from which the player's own body is hurt, by HeardFrom: "hit from behind". They make
/// clear that the player was hit, not the foe.
inline constexpr std::array<std::string_view, 7> hurt_from_words{
    "", "from ahead", "from the right", "from behind", "from the left", "from above", "from below"};
/// Words for the side towards which a force pushes the hand, by HeardFrom.
inline constexpr std::array<std::string_view, 7> pushed_to_words{"",     "away", "right", "towards you",
                                                                 "left", "up",   "down"};

/// One caption: a sound, an effect on the body, or a force on the hand. Two voices (playing sounds) of the
/// same sound from the same side give one line.
struct HeardLine {
    /// Caption of the sound or effect, or name of the force; refers to the loaded data.
    std::string_view words;
    HeardFrom from{};  ///< side from which the sound comes, or towards which the force pushes
    bool important{};
    double age_s{};  ///< time since the sound or force was last heard or felt (s)
    bool own{};      ///< true: the sound or effect hurts or touches the player's own body
    /// Verb for what a force does to the hand, such as "pulls"; empty: not a force on the hand.
    std::string_view verb{};
};

/// The whole line as shown: "step, behind", "weight pulls down".
std::string words_of(const HeardLine& line);
/// Whether a player with this setting is shown the line.
bool wants(HeardWish wish, const HeardLine& line);

/// Time for which a line stays after its sound or force has ended (s).
inline constexpr double heard_seconds = 1.6;

/// Lines of one listener, the oldest first.
class HeardLines {
public:
    /// Adds captions for the voices (playing sounds) of one frame that this listener hears. Call pass_frame
    /// first.
    void follow(const audio::AudioFrame& frame, const audio::SoundBank& bank, std::uint32_t listener);
    /// Makes all lines one frame older (8 ms), and drops those that are too old.
    void pass_frame();
    /// Adds a line, or renews an equal one. A force has only one line, whose side is updated.
    void add(const HeardLine& line);
    std::span<const HeardLine> lines() const { return {lines_.data(), count_}; }

private:
    /// Whether a lasting voice (a playing sound) gets a caption now. Music gets one only when it begins.
    bool tells(const audio::SoundBank& bank, const audio::Voice& voice, bool loud);

    std::array<HeardLine, 8> lines_{};
    std::bitset<256> music_{};  ///< whether a piece of music is being heard, indexed by the sound's number
    std::size_t count_ = 0;
};

/// Side from which a listener hears a position.
HeardFrom side_of(const audio::Listener& listener, vec3 place);

}  // namespace thaum::game::inline senses
