// game/picture/senses_picture.h: one moment of what a player feels, hears and is told, as plain data.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "game/components/match.h"
#include "game/context/arms.h"
#include "game/context/match_context.h"
#include "game/senses/sound/heard.h"
#include "haptics/safety.h"

namespace thaum::game::inline picture {

/// Number of cells of the figure that shows what a player's body feels: 4 x 5 in front, from the top left of
/// the wearer, and as many on the back.
inline constexpr std::size_t figure_cells = 40;

/// Time for which a mark shows the direction of a hurt (s).
inline constexpr double mark_seconds = 1.2;

/// A recent hurt of a player.
struct HurtMark {
    double age_s{};
    vec3 towards{};  ///< unit vector from the victim to the source (world); zero if unknown
};

/// Ticks in one column of the force plot, which shows the strongest force among them.
inline constexpr std::size_t force_column = 16;

/// Force on a player's hand and the state of the device: a real force-feedback arm, or the simulated one that
/// every other hand holds.
struct ForcePicture {
    ArmCondition arm{};            ///< condition of a real force-feedback arm
    haptics::SafetyCause cause{};  ///< why the force on the hand is reduced at present
    double cap{};                  ///< largest force that the hand may get at present (N)
    vec3 current{};                ///< present force (N, device frame, drawn in the eye frame)
    std::string_view source;       ///< name of the strongest source of force (felt_source.h); empty: none
    /// largest net energy that the hand has got from sources that must not create energy, such as springs and
    /// walls (J)
    double created{};
    /// Strongest force of each complete column, the oldest first (N).
    std::array<float, std::tuple_size_v<ForceTrace> / force_column - 1> strongest{};

    /// The present force as a share of its limit.
    double share() const { return cap > 0 ? glm::length(current) / cap : 0; }
};

struct SensesPicture {
    double since_hit_s{};  ///< time since this player last hurt the other one (s)
    /// time since this player's last event with a caption that warns (HudMark::warning) (s)
    double since_warning_s{};
    EventKind warning{};  ///< kind of this player's last event with a caption that warns
    /// time since this player's last event with a caption about a gain (HudMark::gift) (s)
    double since_gift_s{};
    Event gift{};  ///< this player's last event with a caption about a gain
    ForcePicture force{};
    std::uint32_t
        heard_lines{};  ///< number of entries in `heard`, the oldest first; the session fills them in
    std::array<HeardLine, 8> heard{};
    std::array<float, figure_cells> felt{};  ///< strength of what is felt in each cell of the figure, 0 to 1;
                                             ///< the session fills it in
    double since_felt_s{1e6};                ///< time since anything was last felt in a cell of the figure
                                             ///< (s)
    std::uint32_t hurts{};                   ///< number of entries in `marks`
    std::array<HurtMark, 6> marks{};
};

}  // namespace thaum::game::inline picture
