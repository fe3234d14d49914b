// game/live/body.h: what players of a live session feel on the body: the effects, the layouts of motors, and
// the frames (strengths of all motors, every 8 ms) of each match.
//
// The main thread owns a LiveBody. The thread that plays a match or a replay makes a MatchBody for it. The
// effect or layout of a faulty data file is left out, and one line reports the fault.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "game/live/body_sound.h"
#include "game/live/sound.h"
#include "game/live/tactile.h"
#include "game/picture/picture.h"
#include "game/senses/tactile/tactile_scene.h"

namespace thaum::game::inline live {

/// Effects on the body, and layouts (arrangements of motors), that the program has loaded.
struct LiveBody {
    tactile::EffectBank effects;
    tactile::Layout figure;  ///< arrangement of the cells in the body's picture (figure_layout)
    tactile::Layout pad;     ///< the two motors of a pad
    /// A shipped layout of a jacket's motors, with the name of its file.
    struct Worn {
        std::string_view name;
        tactile::Layout layout;
    };
    std::vector<Worn> jackets{};  ///< shipped layouts, in the order of jacket_layouts()

    /// Layouts that players have written for their jackets.
    std::array<std::optional<tactile::Layout>, players> own{};

    /// Lines on faulty effects and layouts. A faulty effect is left out, and a faulty layout has no
    /// actuators.
    std::vector<std::string> faults{};

    /// The error: the folder of effects cannot be read.
    static Expected<LiveBody> load(const std::filesystem::path& assets);
    /// Layout of a player's jacket by the name that LiveTactile::jacket_layout gives; null for another name.
    const tactile::Layout* jacket_of(std::uint32_t player, std::string_view name) const;
    /// Kinds of effect (purposes, such as blasts) of which there is at least one effect, in the order of
    /// tactile::Purpose. Each kind has a fader in the menu.
    std::vector<tactile::Purpose> purposes() const;
};

/// Everything that both players feel on the body in one match. The thread that plays the match owns it.
class MatchBody {
public:
    /// `body`: std::nullopt if nothing is felt; then nothing is computed. `motors` gets the frames for pads
    /// and jackets. `sound`: null if no sounds are felt on the jackets.
    MatchBody(const std::optional<LiveBody>& body, LiveTactile& motors, const LiveSound* sound)
        : body_(body), motors_(motors), sound_(sound) {}

    /// Follows the match after a tick; starts anew with another match or changed data. Adds words on what is
    /// felt on the body to those of `sound`, whose follow() must have been called for this tick.
    void follow(const Simulation& match, MatchSound& sound);
    /// Forgets what was felt, after a jump to another time in a replay.
    void forget();
    /// Adds to `picture` how brightly each cell of the drawn body is lit; a cell stands for one place of the
    /// body.
    void show(Picture& picture) const;

private:
    void begin(const Simulation& match);
    bool hears(std::uint32_t player) const;
    void hear(const Simulation& match);
    void feel(std::uint32_t player, const Simulation& match);

    void take_faders(std::uint32_t player);
    std::size_t jackets_of(std::uint32_t player) const;
    std::string_view name_of_jacket(std::size_t number) const;

    const std::optional<LiveBody>& body_;
    LiveTactile& motors_;
    const LiveSound* sound_;
    std::optional<BodySound> felt_sound_{};
    const MatchData* data_{};  ///< match data for which `scenes_` were made
    std::optional<MatchEffects> effects_{};
    std::array<std::optional<TactileScene>, players> scenes_{};
    /// each player's strengths of the kinds of effect (faders) that `scenes_` uses now
    std::array<std::optional<tactile::Faders>, players> faders_{};
    /// last tick at which any cell of the body's picture was lit, for each player
    std::array<Tick, players> felt_at_{};
    Tick now_{};
    bool still_ = true;  ///< true: no frame was made since the last jump in time
};

}  // namespace thaum::game::inline live
