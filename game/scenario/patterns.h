// game/scenario/patterns.h: Lua 5.4's patterns (reference manual, 6.4.1) for scripts, with every comparison counted.
// Lua's own matcher counts nothing, so one call with a few repetitions may take longer than a match is played.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace thaum::game {

inline constexpr std::size_t most_captures = 32;

/// A part of the subject that a pattern has captured.
struct Capture {
    enum class Kind : std::uint8_t { open, closed, position };
    std::size_t begin{}, size{};  ///< bytes; a position has no size
    Kind kind{};
};

/// One search of one subject. It allocates nothing and throws nothing, so a Lua error may jump over it.
class PatternMatch {
public:
    /// Counts steps; false: there are none left, and the search ends with a fault.
    using Spend = bool (*)(void* context, std::uint64_t steps);

    /// `pattern` is without the anchor ^ at its begin.
    PatternMatch(std::string_view subject, std::string_view pattern, Spend count, void* context)
        : subject_(subject), pattern_(pattern), spend_(count), context_(context) {}

    /// Matches from this place of the subject on; false where it does not match, or with `fault`.
    bool match_at(std::size_t begin);
    /// The end of the match.
    std::size_t end() const { return end_; }
    /// Why the pattern is none, or why the search has been given up; null: neither.
    const char* fault() const { return fault_; }

    std::size_t captures() const { return count_; }
    /// One that the pattern never closes is still open.
    const Capture& capture(std::size_t i) const { return list_[i]; }
    /// Counts work that the caller does for this search.
    bool spend(std::uint64_t steps);

private:
    static constexpr std::size_t no_match = ~std::size_t{0};

    std::size_t match(std::size_t s, std::size_t p);
    std::size_t repeated(std::size_t s, std::size_t p, std::size_t after);
    std::size_t most_first(std::size_t s, std::size_t p, std::size_t after);
    std::size_t least_first(std::size_t s, std::size_t p, std::size_t after);
    std::size_t open_capture(std::size_t s, std::size_t p, Capture::Kind kind);
    std::size_t close_capture(std::size_t s, std::size_t p);
    std::size_t balanced(std::size_t s, std::size_t p);
    std::size_t frontier(std::size_t s, std::size_t p);
    std::size_t same_again(std::size_t s, std::size_t p);
    std::size_t item_end(std::size_t p);
    bool item_matches(std::size_t s, std::size_t p, std::size_t after);
    bool in_set(unsigned char c, std::size_t p, std::size_t last);
    std::size_t wrong(const char* fault);

    std::string_view subject_, pattern_;
    Spend spend_;
    void* context_;
    std::array<Capture, most_captures> list_{};
    std::size_t count_ = 0;
    std::size_t end_ = 0;
    int depth_ = 0;
    const char* fault_ = nullptr;
};

/// Where `wanted` begins in the subject from `from` on, each byte compared counted; npos: nowhere, or no steps are left.
std::size_t find_plain(std::string_view subject, std::string_view wanted, std::size_t from,
                       PatternMatch::Spend spend, void* context);

}  // namespace thaum::game
