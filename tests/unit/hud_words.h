// unit/hud_words.h: the texts of an overlay and where they are.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "game/hud/panel.h"
#include "render/font.h"
#include "unit/overlay_items.h"

namespace thaum::game::hud_tests {

struct SaidWords {
    std::string words;
    Panel box;
};

/// The texts of an overlay and where they are. Each is drawn twice, because a dark copy lies below it.
inline std::vector<SaidWords> words_of(const render::Overlay& overlay, render::Font& font) {
    std::vector<SaidWords> all;
    const render::TextItem* before = nullptr;
    for (const auto* said : items_of<render::TextItem>(overlay)) {
        if (before != nullptr && before->text == said->text) {
            const auto size = font.measure(said->text, said->size);
            const float left = said->align == render::Align::left     ? 0
                               : said->align == render::Align::centre ? size.x / 2
                                                                      : size.x;
            const fvec2 low = said->position - fvec2(left, 0);
            all.push_back({said->text, {low, low + size}});
            before = nullptr;
        } else {
            before = said;
        }
    }
    return all;
}

inline bool overlap(const Panel& a, const Panel& b) {
    constexpr float slack = 0.01F;
    return a.low.x + slack < b.high.x && b.low.x + slack < a.high.x && a.low.y + slack < b.high.y &&
           b.low.y + slack < a.high.y;
}

/// Expects that no two texts overlap. `where` names the case.
inline void expect_apart(const std::vector<SaidWords>& words, const std::string& where) {
    for (std::size_t a = 0; a < words.size(); ++a)
        for (std::size_t b = a + 1; b < words.size(); ++b)
            EXPECT_FALSE(overlap(words[a].box, words[b].box))
                << where << ": '" << words[a].words << "' and '" << words[b].words << "'";
}

}  // namespace thaum::game::hud_tests
