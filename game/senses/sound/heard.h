// game/senses/sound/heard.h: what is heard and felt in words, for players who do not hear or feel it: "step, behind", "weight
// pulls down". The words of sounds are those of the sounds that a frame begins or keeps up, so nothing is heard that
// has no words. game/senses adds what the hand and the body feel.
#pragma once
#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "audio/frame.h"

namespace thaum::game {

/// What a player wants in words of all that is heard and felt.
enum class HeardWish : std::uint8_t { none, important, all };

/// Side from which a sound comes. `here`: from the listener, or from no place.
enum class HeardFrom : std::uint8_t { here, ahead, right, behind, left, above, below };
inline constexpr std::array<std::string_view, 7> heard_from_words{"",     "ahead", "right", "behind",
                                                                  "left", "above", "below"};

/// Words for the side from which the own body is hurt, by HeardFrom: "hit from behind". So nobody takes the foe's hit
/// for an own one.
inline constexpr std::array<std::string_view, 7> hurt_from_words{
    "", "from ahead", "from the right", "from behind", "from the left", "from above", "from below"};
/// Words for the side to which a force pushes the hand, by HeardFrom.
inline constexpr std::array<std::string_view, 7> pushed_to_words{"",     "away", "right", "towards you",
                                                                 "left", "up",   "down"};

/// A sound, an effect on the body or a force on the hand in words. Two voices of one sound from one side are one line.
struct HeardLine {
    std::string_view words;  ///< caption of the sound or effect, or name of the force; it belongs to the data
    HeardFrom from{};        ///< side from which it comes, or to which a force pushes
    bool important{};
    double age_s{};           ///< time since it was last heard or felt
    bool own{};               ///< it hurts or touches the own body
    std::string_view verb{};  ///< what a force does to the hand, such as "pulls"; empty: no force on the hand
};

/// The whole line as shown: "step, behind", "weight pulls down".
std::string words_of(const HeardLine& line);
/// Whether a player with this wish is shown the line.
bool wants(HeardWish wish, const HeardLine& line);

/// Time for which a line stays after its sound or force (s).
inline constexpr double heard_seconds = 1.6;

/// Lines of one listener, the oldest first.
class HeardLines {
public:
    /// Takes the voices of one frame that this listener hears. `pass_frame` has gone before.
    void follow(const audio::AudioFrame& frame, const audio::SoundBank& bank, std::uint32_t listener);
    /// Lets the time of one frame pass.
    void pass_frame();
    /// Adds a line, or keeps an equal one up. Of a force there is one line, whose side changes.
    void add(const HeardLine& line);
    std::span<const HeardLine> lines() const { return {lines_.data(), count_}; }

private:
    /// Whether the caption of a lasting voice is to be told. That of music is told once, when it begins.
    bool tells(const audio::SoundBank& bank, const audio::Voice& voice, bool loud);

    std::array<HeardLine, 8> lines_{};
    std::bitset<256> music_{};  ///< by number of the sound: music that is heard
    std::size_t count_ = 0;
};

/// Side from which a listener hears a place.
HeardFrom side_of(const audio::Listener& listener, vec3 place);

}  // namespace thaum::game
