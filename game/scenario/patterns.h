// game/scenario/patterns.h: Lua 5.4 patterns (reference manual, 6.4.1) for scripts, with every comparison
// counted. Lua's own matcher counts nothing, so one call with a few repetitions can take longer than a whole
// match.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace thaum::game {

inline constexpr std::size_t most_captures = 32;

/// A captured part of the subject.
struct Capture {
    enum class Kind : std::uint8_t { open, closed, position };
    std::size_t begin{}, size{};  ///< range in bytes; a position capture has size 0
    Kind kind{};
};

/// One search in one subject. It allocates nothing and throws nothing, so a Lua error can jump over it.
class PatternMatch {
public:
    /// Counts steps. Returns false if the steps are used up, and the search then ends with a fault.
    using Spend = bool (*)(void* context, std::uint64_t steps);

    /// `pattern` has no leading anchor ^.
    PatternMatch(std::string_view subject, std::string_view pattern, Spend count, void* context)
        : subject_(subject), pattern_(pattern), spend_(count), context_(context) {}

    /// Matches from this place of the subject. Returns false if there is no match, or if `fault` is set.
    bool match_at(std::size_t begin);
    /// End of the match.
    std::size_t end() const { return end_; }
    /// Error in the pattern, or the reason why the search was given up; null if there is none.
    const char* fault() const { return fault_; }

    std::size_t captures() const { return count_; }
    /// Capture i. Its kind stays `open` if the pattern never closes it.
    const Capture& capture(std::size_t i) const { return list_[i]; }
    /// Counts work that the caller does for this search.
    bool spend(std::uint64_t steps);

private:
    static constexpr std::size_t no_match = ~std::size_t{0};

    /// Places in subject and pattern after an item.
    struct Progress {
        std::size_t s{}, p{};
        bool ended{};  ///< the match ends at `s`, or there is none
    };
    static Progress ended_at(std::size_t s) { return {s, 0, true}; }
    static Progress went_on(std::size_t s, std::size_t p) { return {s, p, s == no_match}; }

    std::size_t match(std::size_t s, std::size_t p);
    Progress match_item(std::size_t s, std::size_t p);
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

/// Position of the first `wanted` in the subject at or after `from`, counting every compared byte. Returns
/// npos if there is none, or if the steps are used up.
std::size_t find_plain(std::string_view subject, std::string_view wanted, std::size_t from,
                       PatternMatch::Spend spend, void* context);

}  // namespace thaum::game
