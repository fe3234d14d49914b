// game/data/gesture_set.h: the gestures that strokes can be recognised as, with their recogniser.
#pragma once
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gesture/prefix.h"
#include "gesture/recogniser.h"

namespace thaum::game::inline data {

/// Gestures with their recognisers, shared by all matches with the same data. Each recogniser is made when it
/// is first needed, in any thread.
class GestureSet {
public:
    /// The gestures must have been checked by `fault_of`.
    explicit GestureSet(std::vector<gesture::Gesture> gestures) : gestures_(std::move(gestures)) {}

    std::span<const gesture::Gesture> gestures() const { return gestures_; }
    /// Number of the gesture of this name.
    std::optional<std::uint32_t> number(std::string_view name) const;
    /// Name of a gesture by its number; empty for a number without a gesture.
    std::string_view name(std::uint32_t number) const;
    /// Recogniser of strokes that are drawn with a button.
    const gesture::Recogniser& recogniser() const;
    /// Recogniser of gestures in a hand's motion without a button, which also considers how fast the hand
    /// moves. Made only for a match in which somebody casts in this way (freely).
    const gesture::Recogniser& motion_recogniser() const;
    /// Whether the recogniser of motion has been made. Not to be asked while another thread may be making it.
    bool has_motion_recogniser() const { return motion_recogniser_.has_value(); }
    /// Reader of unfinished strokes, made when it is first needed, in any thread.
    /// For pictures, never for a match.
    const gesture::PrefixReader& prefixes() const;

private:
    std::vector<gesture::Gesture> gestures_;
    mutable std::once_flag once_, once_motion_, once_prefixes_;
    mutable std::optional<gesture::Recogniser> recogniser_, motion_recogniser_;
    mutable std::optional<gesture::PrefixReader> prefixes_;
};

/// Why no recogniser can be made of these gestures, in words; std::nullopt if one can.
std::optional<std::string> fault_of(std::span<const gesture::Gesture> gestures);

}  // namespace thaum::game::inline data
