#include "game/scenario/patterns.h"

#include <algorithm>
#include <cstring>

namespace thaum::game {
namespace {

constexpr int most_depth = 200;
constexpr const char* out_of_steps =
    "the script has spent all its steps: this pattern on a text of that length takes too long";

bool between(unsigned char c, char low, char high) {
    return c >= static_cast<unsigned char>(low) && c <= static_cast<unsigned char>(high);
}
bool is_letter(unsigned char c) { return between(c, 'a', 'z') || between(c, 'A', 'Z'); }
bool is_digit(unsigned char c) { return between(c, '0', '9'); }
bool is_printed(unsigned char c) { return c > 0x20 && c < 0x7f; }
bool is_space(unsigned char c) { return c == ' ' || between(c, '\t', '\r'); }
bool is_hexadecimal(unsigned char c) { return is_digit(c) || between(c, 'a', 'f') || between(c, 'A', 'F'); }

/// Tests the classes %a, %d ... of ASCII, in any locale. A capital letter names the complement.
bool in_class(unsigned char c, unsigned char name) {
    const auto lower = static_cast<char>(between(name, 'A', 'Z') ? name - 'A' + 'a' : name);
    bool found = false;
    switch (lower) {
        case 'a': found = is_letter(c); break;
        case 'c': found = c < 0x20 || c == 0x7f; break;
        case 'd': found = is_digit(c); break;
        case 'g': found = is_printed(c); break;
        case 'l': found = between(c, 'a', 'z'); break;
        case 'p': found = is_printed(c) && !is_letter(c) && !is_digit(c); break;
        case 's': found = is_space(c); break;
        case 'u': found = between(c, 'A', 'Z'); break;
        case 'w': found = is_letter(c) || is_digit(c); break;
        case 'x': found = is_hexadecimal(c); break;
        default: return name == c;
    }
    return found != between(name, 'A', 'Z');
}

}  // namespace

std::size_t PatternMatch::wrong(const char* fault) {
    if (fault_ == nullptr) fault_ = fault;
    return no_match;
}

bool PatternMatch::spend(std::uint64_t steps) {
    if (spend_(context_, steps)) return true;
    wrong(out_of_steps);
    return false;
}

bool PatternMatch::match_at(std::size_t begin) {
    count_ = 0;
    depth_ = 0;
    end_ = match(begin, 0);
    return end_ != no_match && fault_ == nullptr;
}

/// Matches the pattern from `p` against the subject from `s`. Returns the end of the match.
std::size_t PatternMatch::match(std::size_t s, std::size_t p) {
    if (++depth_ > most_depth) return wrong("pattern too complex");
    Progress at{s, p};
    while (!at.ended && at.p < pattern_.size() && fault_ == nullptr && spend(1)) at = match_item(at.s, at.p);
    --depth_;
    return fault_ == nullptr ? at.s : no_match;
}

/// Matches the item of the pattern at `p`. A capture, a repetition and the last `$` also match all that follows
/// them, so they end the match.
PatternMatch::Progress PatternMatch::match_item(std::size_t s, std::size_t p) {
    const char c = pattern_[p];
    const char next = p + 1 < pattern_.size() ? pattern_[p + 1] : '\0';
    if (c == '(' && next == ')') return ended_at(open_capture(s, p + 2, Capture::Kind::position));
    if (c == '(') return ended_at(open_capture(s, p + 1, Capture::Kind::open));
    if (c == ')') return ended_at(close_capture(s, p + 1));
    if (c == '$' && p + 1 == pattern_.size()) return ended_at(s == subject_.size() ? s : no_match);
    if (c == '%' && next == 'b') return went_on(balanced(s, p + 2), p + 4);
    if (c == '%' && next == 'f') {
        const auto border = frontier(s, p + 2);
        return border == no_match ? ended_at(no_match) : went_on(border, item_end(p + 2));
    }
    if (c == '%' && is_digit(static_cast<unsigned char>(next))) return went_on(same_again(s, p + 1), p + 2);
    const auto end = item_end(p);
    if (fault_ != nullptr) return ended_at(no_match);
    const char suffix = end < pattern_.size() ? pattern_[end] : '\0';
    if (suffix == '*' || suffix == '+' || suffix == '-' || suffix == '?')
        return ended_at(repeated(s, p, end));
    return item_matches(s, p, end) ? went_on(s + 1, end) : ended_at(no_match);
}

std::size_t PatternMatch::repeated(std::size_t s, std::size_t p, std::size_t after) {
    switch (pattern_[after]) {
        case '-': return least_first(s, p, after);
        case '*': return most_first(s, p, after);
        case '+': return item_matches(s, p, after) ? most_first(s + 1, p, after) : no_match;
        default: break;
    }
    if (item_matches(s, p, after)) {
        const auto found = match(s + 1, after + 1);
        if (found != no_match) return found;
    }
    return match(s, after + 1);
}

std::size_t PatternMatch::most_first(std::size_t s, std::size_t p, std::size_t after) {
    std::size_t count = 0;
    while (spend(1) && item_matches(s + count, p, after)) ++count;
    for (; fault_ == nullptr; --count) {
        const auto found = match(s + count, after + 1);
        if (found != no_match || count == 0) return found;
    }
    return no_match;
}

std::size_t PatternMatch::least_first(std::size_t s, std::size_t p, std::size_t after) {
    while (fault_ == nullptr && spend(1)) {
        const auto found = match(s, after + 1);
        if (found != no_match) return found;
        if (!item_matches(s, p, after)) return no_match;
        ++s;
    }
    return no_match;
}

std::size_t PatternMatch::open_capture(std::size_t s, std::size_t p, Capture::Kind kind) {
    if (count_ == most_captures) return wrong("too many captures");
    list_[count_++] = {s, 0, kind};
    const auto found = match(s, p);
    if (found == no_match) --count_;
    return found;
}

std::size_t PatternMatch::close_capture(std::size_t s, std::size_t p) {
    auto i = count_;
    while (i > 0 && list_[i - 1].kind != Capture::Kind::open) --i;
    if (i == 0) return wrong("invalid pattern capture");
    auto& capture = list_[i - 1];
    capture.size = s - capture.begin;
    capture.kind = Capture::Kind::closed;
    const auto found = match(s, p);
    if (found == no_match) capture.kind = Capture::Kind::open;
    return found;
}

/// %bxy: from an x to the y that closes it.
std::size_t PatternMatch::balanced(std::size_t s, std::size_t p) {
    if (p + 1 >= pattern_.size()) return wrong("malformed pattern (missing arguments to '%b')");
    if (s >= subject_.size() || subject_[s] != pattern_[p]) return no_match;
    std::size_t open = 1;
    for (auto at = s + 1; at < subject_.size(); ++at) {
        if (!spend(1)) return no_match;
        if (subject_[at] == pattern_[p + 1]) {
            if (--open == 0) return at + 1;
        } else if (subject_[at] == pattern_[p]) {
            ++open;
        }
    }
    return no_match;
}

/// %f[set]: the border between a byte outside the set and a byte in it. The ends of the subject count as zero
/// bytes.
std::size_t PatternMatch::frontier(std::size_t s, std::size_t p) {
    if (p >= pattern_.size() || pattern_[p] != '[') return wrong("missing '[' after '%f' in pattern");
    const auto end = item_end(p);
    if (fault_ != nullptr) return no_match;
    const auto byte_at = [&](std::size_t at) {
        return static_cast<unsigned char>(at < subject_.size() ? subject_[at] : '\0');
    };
    const auto before = s == 0 ? byte_at(subject_.size()) : byte_at(s - 1);
    return !in_set(before, p, end - 1) && in_set(byte_at(s), p, end - 1) ? s : no_match;
}

/// %1 ... %9: the text of an earlier capture.
std::size_t PatternMatch::same_again(std::size_t s, std::size_t p) {
    const auto number = static_cast<std::size_t>(pattern_[p] - '1');
    if (pattern_[p] == '0' || number >= count_ || list_[number].kind == Capture::Kind::open)
        return wrong("invalid capture index in pattern");
    const auto& capture = list_[number];
    if (capture.kind == Capture::Kind::position) return no_match;
    if (!spend(capture.size / 16) || subject_.size() - s < capture.size) return no_match;
    return subject_.substr(s, capture.size) == subject_.substr(capture.begin, capture.size) ? s + capture.size
                                                                                            : no_match;
}

/// Position after the single item (a byte, a class or a set) at `p`.
std::size_t PatternMatch::item_end(std::size_t p) {
    if (pattern_[p] == '%') {
        return p + 1 < pattern_.size() ? p + 2 : wrong("malformed pattern (ends with '%')");
    }
    if (pattern_[p] != '[') return p + 1;
    auto at = p + 1;
    if (at < pattern_.size() && pattern_[at] == '^') ++at;
    // A bracket in first position belongs to the set.
    for (bool first = true; first || at >= pattern_.size() || pattern_[at] != ']'; first = false) {
        if (at >= pattern_.size()) return wrong("malformed pattern (missing ']')");
        at += pattern_[at] == '%' ? 2 : 1;
    }
    if (!spend((at - p) / 16)) return no_match;
    return at + 1;
}

bool PatternMatch::item_matches(std::size_t s, std::size_t p, std::size_t after) {
    if (s >= subject_.size()) return false;
    const auto c = static_cast<unsigned char>(subject_[s]);
    switch (pattern_[p]) {
        case '.': return true;
        case '%': return in_class(c, static_cast<unsigned char>(pattern_[p + 1]));
        case '[': return in_set(c, p, after - 1);
        default: return static_cast<unsigned char>(pattern_[p]) == c;
    }
}

/// Tests a byte against the set between the brackets at `p` and `last`.
bool PatternMatch::in_set(unsigned char c, std::size_t p, std::size_t last) {
    spend((last - p) / 16);
    auto at = p + 1;
    const bool others = pattern_[at] == '^';
    if (others) ++at;
    for (; at < last; ++at) {
        if (pattern_[at] == '%') {
            if (in_class(c, static_cast<unsigned char>(pattern_[++at]))) return !others;
        } else if (at + 2 < last && pattern_[at + 1] == '-') {
            if (between(c, pattern_[at], pattern_[at + 2])) return !others;
            at += 2;
        } else if (static_cast<unsigned char>(pattern_[at]) == c) {
            return !others;
        }
    }
    return others;
}

std::size_t find_plain(std::string_view subject, std::string_view wanted, std::size_t from,
                       PatternMatch::Spend spend, void* context) {
    constexpr std::size_t bytes_per_step = 16;
    if (wanted.empty()) return from;
    while (wanted.size() <= subject.size() - from) {
        const auto* const begin = subject.data() + from;
        const auto* const found = static_cast<const char*>(
            std::memchr(begin, wanted[0], subject.size() - from - wanted.size() + 1));
        const auto passed =
            found == nullptr ? subject.size() - from : static_cast<std::size_t>(found - begin);
        if (!spend(context, 1 + passed / bytes_per_step) || found == nullptr) return std::string_view::npos;
        std::size_t same = 1;
        while (same < wanted.size() && found[same] == wanted[same]) ++same;
        if (!spend(context, same / bytes_per_step)) return std::string_view::npos;
        from += passed;
        if (same == wanted.size()) return from;
        ++from;
    }
    return std::string_view::npos;
}

}  // namespace thaum::game
