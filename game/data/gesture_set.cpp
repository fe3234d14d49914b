#include "game/data/gesture_set.h"

#include <algorithm>

#include "core/assert.h"

namespace thaum::game::inline data {
namespace {

/// Returns a reader of the gestures (a recogniser of some kind), which is created on first use because that
/// takes long.
template <class Reader, class... Settings>
const Reader& made_once(std::once_flag& once, std::optional<Reader>& reader,
                        std::span<const gesture::Gesture> gestures, const Settings&... settings) {
    std::call_once(once, [&] {
        auto made = Reader::make(gestures, settings...);
        THAUM_ASSERT(made, "gestures of a set were checked");
        reader = std::move(*made);
    });
    return *reader;
}

}  // namespace

std::optional<std::uint32_t> GestureSet::number(std::string_view name) const {
    const auto found = std::find_if(gestures_.begin(), gestures_.end(),
                                    [&](const gesture::Gesture& g) { return g.name == name; });
    if (found == gestures_.end()) return {};
    return static_cast<std::uint32_t>(found - gestures_.begin());
}

std::string_view GestureSet::name(std::uint32_t number) const {
    return number < gestures_.size() ? std::string_view(gestures_[number].name) : std::string_view();
}

const gesture::Recogniser& GestureSet::recogniser() const { return made_once(once_, recogniser_, gestures_); }

const gesture::Recogniser& GestureSet::motion_recogniser() const {
    const gesture::RecogniserSettings motion{.pace_counts = true};
    return made_once(once_motion_, motion_recogniser_, gestures_, motion);
}

const gesture::PrefixReader& GestureSet::prefixes() const {
    return made_once(once_prefixes_, prefixes_, gestures_);
}

std::optional<std::string> fault_of(std::span<const gesture::Gesture> gestures) {
    const auto made = gesture::Recogniser::make(gestures, {.calibrate = false});
    if (made) return {};
    return made.error().message;
}

}  // namespace thaum::game::inline data
