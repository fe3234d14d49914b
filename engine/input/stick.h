// input/stick.h: how far a stick is pushed, after the dead zone and the response curve that its player chose. The
// result becomes counts of a DeviceSample, so the log has both choices in it and a replay needs neither.
#pragma once

namespace thaum::input {

/// How the sticks of one player respond.
struct StickResponse {
    /// Radius around the middle in which a push counts as none, 0 to 0.9. The rest is stretched to 0..1.
    double dead_zone = 0.15;
    /// Share of the cubic part in the rate of a turn, 0 to 1: pushed by x, a stick turns at the full rate
    /// times (1 - curve) x + curve x^3. With 0 it turns in proportion to x; with 1 it is finest near the middle.
    double curve = 0.7;

    /// The same, with numbers that are not finite or out of range replaced by the nearest useful ones.
    StickResponse checked() const;
};

/// A push of a stick or trigger, limited to -1..1. A broken driver's NaN or infinity counts as none.
double checked_push(double push);

struct StickPosition {
    double x{}, y{};  ///< -1..1
};

/// Position without the dead zone. The zone is round, so that a diagonal keeps its direction and slow circles stay
/// round. The result grows from 0 at the zone's edge to a length of 1.
StickPosition without_dead_zone(StickPosition raw, double dead_zone);

/// Rate of a turn that every match gives a deflection (-1..1), as a share of the full rate: the curve 0.7. It acts
/// inside the tick on logged counts, so it must never change.
constexpr double turn_share(double deflection) { return deflection * (0.3 + 0.7 * deflection * deflection); }

/// Deflection (-1..1) to log, so that turn_share gives the rate that `curve` gives a push (-1..1). The usual curve
/// leaves the push exactly as it is.
double deflection_for(double push, double curve);

}  // namespace thaum::input
