// game/jackets/place_name.h: places of jackets (the part after the colon of the setting) that are the name of
// a device, or a path.
#pragma once
#include "core/one_line.h"

namespace thaum::game::inline jackets {

/// Whether words may be a device's name or a path: one printable line of a sensible length.
inline bool fits_name(std::string_view words) {
    constexpr std::size_t longest_name = 1000;  ///< largest length of a name or path (bytes)
    return !words.empty() && words.size() <= longest_name && printable(words, words.size()) == words;
}

}  // namespace thaum::game::inline jackets
