#include "game/jackets/jacket.h"

#include <algorithm>

#include "core/one_line.h"
#include "core/text.h"

namespace thaum::game::inline jackets {
namespace {

constexpr std::size_t max_words_shown = 60;

Error no_jacket(std::string_view words, std::string_view why) {
    return fail(text("'", printable(words, max_words_shown), "' is no jacket: ", why));
}

/// The kind of jacket that the setting names by this word, without a place; no jacket if no maker has such a
/// kind.
Jacket with_word(std::string_view word) {
    for (const auto& maker : jacket_makers()) {
        const auto found = std::ranges::find(maker.forms, word, &JacketForm::word);
        if (found != maker.forms.end()) return {.maker = &maker, .form = &*found};
    }
    return {};
}

}  // namespace

std::vector<JacketLayout> jacket_layouts() {
    std::vector<JacketLayout> layouts;
    for (const auto& maker : jacket_makers())
        for (const auto& form : maker.forms)
            if (std::ranges::find(layouts, form.layout.name, &JacketLayout::name) == layouts.end())
                layouts.push_back(form.layout);
    return layouts;
}

std::string jacket_forms() {
    std::vector<std::string_view> shown;
    for (const auto& maker : jacket_makers())
        shown.insert(shown.end(), maker.shown.begin(), maker.shown.end());
    std::string words;
    for (std::size_t i = 0; i < shown.size(); ++i)
        words += text(i == 0 ? "" : i + 1 == shown.size() ? " or " : ", ", "\"", shown[i], "\"");
    return words;
}

Expected<Jacket> parse_jacket(std::string_view words) {
    if (words.empty()) return Jacket{};
    const auto colon = words.find(':');
    const auto word = words.substr(0, colon);
    auto jacket = with_word(word);
    if (!jacket || (colon == std::string_view::npos && !jacket.form->usual_place))
        return no_jacket(words, text("use \"\", ", jacket_forms()));
    if (colon == std::string_view::npos) {
        jacket.place = *jacket.form->usual_place;
        return jacket;
    }
    auto place = jacket.maker->read(word, words.substr(colon + 1));
    if (!place) return no_jacket(words, place.error().message);
    jacket.place = std::move(*place);
    return jacket;
}

Expected<tactile::Layout> load_own_layout(const std::string& words, const Jacket& jacket,
                                          const std::filesystem::path& assets) {
    const bool is_path = words.find('/') != std::string::npos;
    auto layout = tactile::load_layout(is_path ? std::filesystem::path(words)
                                               : assets / "tactile" / "layouts" / (words + ".toml"));
    if (!layout) return layout;
    if (jacket && !jacket.maker->keeps_layout.empty())
        return fail(text("'jacket_layout': ", jacket.maker->keeps_layout));
    const auto motors = jacket.layout().motors;
    if (layout->actuators.size() > motors)
        return fail(text("'jacket_layout': '", printable(words, max_words_shown), "' has ",
                         layout->actuators.size(), " actuators, and the jacket ", motors, " motors"));
    return layout;
}

bool is_same_device(const Jacket& a, const Jacket& b) { return a.maker == b.maker && a.place == b.place; }

std::unique_ptr<input::TactileOutput> jacket_output(const Jacket& jacket, std::uint32_t player) {
    return jacket ? jacket.maker->make(jacket, player) : nullptr;
}

}  // namespace thaum::game::inline jackets
