// input/stick.h: how far a stick is pushed, after the dead zone and the response curve that its player chose.
// The result is stored as counts of a DeviceSample, so a replay needs neither setting.
#pragma once

namespace thaum::input {

/// How the sticks of one player respond.
struct StickResponse {
    /// Radius around the middle within which a push is ignored, 0 to 0.9. The remaining range is stretched to
    /// 0..1.
    double dead_zone = 0.15;
    /// Share of the cubic part in the rate of a turn, 0 to 1: pushed by x, a stick turns at
    /// the full rate times (1 - curve) x + curve x^3. With 0 it turns in proportion to x; with
    /// 1 it is finest near the middle.
    double curve = 0.7;

    /// Copy of these settings, with values that are not finite or out of range replaced by the nearest useful
    /// ones.
    StickResponse checked() const;
};

/// A push of a stick or trigger, limited to -1..1. NaN or infinity from a faulty driver counts as 0.
double checked_push(double push);

/// Deflection of a stick, positive to the right and up.
struct StickPosition {
    double x{}, y{};  ///< deflection to the right and upwards, -1..1
};

/// Stick position after removing the dead zone. The zone is round, so that a diagonal keeps its direction and
/// slow circles stay round. The result grows from 0 at the zone's edge to a length of 1.
StickPosition without_dead_zone(StickPosition raw, double dead_zone);

/// Turn rate for a deflection (-1..1) in every match, as a share of the full rate: the response curve with
/// `curve` 0.7. It is applied inside the tick to logged counts, so it must never change.
constexpr double turn_share(double deflection) { return deflection * (0.3 + 0.7 * deflection * deflection); }

/// Deflection (-1..1) to log, so that turn_share gives the rate that `curve` gives a push (-1..1). With the
/// default curve it is exactly the push.
double deflection_for(double push, double curve);

}  // namespace thaum::input
