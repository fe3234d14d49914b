// render/pass_times.h: where the time of a picture goes, by passes.
#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <string_view>

namespace thaum::render {

/// Parts of the work on a picture, roughly in their order.
enum class Pass : std::uint8_t {
    changes,    ///< sends new triangles and draws the shadow map
    selection,  ///< finds what each view sees
    volumes,    ///< marches rays through volumes such as the brew and shows them
    meshes,     ///< draws everything solid, and the sky
    scans,      ///< marches rays through scans such as the crystals
    mists,      ///< steam and spells
    window,     ///< brings the views, which have targets of their own, into the window
    overlay,    ///< text and panels
};
inline constexpr std::size_t passes = 8;
inline constexpr std::array<std::string_view, passes> pass_names{
    "changes", "selection", "volumes", "meshes", "scans", "mists", "window", "overlay"};

/// Durations of the passes of one picture.
struct PassTimes {
    std::array<double, passes> ms{};
    double operator[](Pass pass) const { return ms[static_cast<std::size_t>(pass)]; }
    bool operator==(const PassTimes&) const = default;
    /// Sum of the durations (ms).
    double total_ms() const { return std::accumulate(ms.begin(), ms.end(), 0.0); }
};

/// Measures passes while it is on. It then waits at the end of each until all of it is drawn, so a picture
/// takes longer than usual: passes do not overlap.
class PassClock {
public:
    bool on{};  ///< false: nothing waits and nothing is measured

    /// Begins a new picture.
    void start();
    /// Adds the time since the last call of either function to a pass.
    void end(Pass pass);
    /// Times of the last picture; zeros if it was not measured.
    const PassTimes& times() const { return times_; }

private:
    std::chrono::steady_clock::time_point last_{};
    PassTimes times_;
};

}  // namespace thaum::render
