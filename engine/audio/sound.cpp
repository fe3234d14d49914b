#include "audio/sound.h"

#include <algorithm>

namespace thaum::audio {

std::optional<std::uint32_t> SoundBank::find(std::string_view name) const {
    const auto found =
        std::lower_bound(sounds.begin(), sounds.end(), name,
                         [](const Sound& sound, std::string_view wanted) { return sound.name < wanted; });
    if (found == sounds.end() || found->name != name) return std::nullopt;
    return static_cast<std::uint32_t>(found - sounds.begin());
}

}  // namespace thaum::audio
