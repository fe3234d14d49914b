#include "core/near_name.h"

#include <algorithm>
#include <vector>

#include "core/letters.h"
#include "core/text.h"

namespace thaum {
namespace {

/// Longest word that is compared (bytes), because the work grows with the square of the length.
constexpr std::size_t longest_word = 64;

char plain(char c) { return c == '-' ? '_' : lower_case(c); }

/// Least number of edits that turn one word into the other (optimal string alignment).
std::size_t changes_between(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = plain(a[i - 1]) == plain(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && plain(a[i - 1]) == plain(b[j - 2]) && plain(a[i - 2]) == plain(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

}  // namespace

std::string_view near_name(std::string_view word, std::span<const std::string_view> names) {
    if (word.size() > longest_word || std::ranges::find(names, word) != names.end()) return {};
    // Allows one edit in a word of 3 to 6 letters, two in a word of 7 to 10, and three in a longer one. A
    // word of two letters allows none, because every other such word would be near.
    std::size_t least = std::min<std::size_t>((word.size() + 1) / 4, 3) + 1;
    std::string_view nearest;
    for (const auto name : names) {
        if (name.empty() || name.size() > longest_word) continue;
        const auto changes = changes_between(word, name);
        if (changes >= least || changes >= name.size()) continue;
        least = changes;
        nearest = name;
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> names) {
    const auto near = near_name(word, names);
    return near.empty() ? "" : text("; did you mean '", near, "'?");
}

}  // namespace thaum
