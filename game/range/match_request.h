// game/range/match_request.h: a request to the running match, as a value that one thread hands to another.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>

namespace thaum::game::inline range {

class Practice;

/// Objects on which a request to the running match can act.
struct RequestTarget {
    Practice* practice{};       ///< the practice; null: the match is not on the practice range
    std::uint32_t& next_press;  ///< buttons that the next input frame presses (bits of input::Button)
};

template <class T>
concept ActsOnMatch = requires(const T& request, RequestTarget& target) {
    request.carry_out(target);
};
template <class T>
concept ActsOnRange = requires(const T& request, Practice& practice) {
    request.carry_out(practice);
};

/// A request to the running match. It holds any small plain struct with a function `void carry_out(
/// RequestTarget&) const`, or `void carry_out(Practice&) const`, which is called only on the practice range.
/// A new kind of request is a new struct and needs no change in menu, session or simulation, because none of
/// them lists the kinds.
class MatchRequest {
public:
    static constexpr std::size_t max_bytes = 8;

    /// A request that does nothing.
    MatchRequest() = default;
    template <class T>
    requires(!std::is_same_v<T, MatchRequest> && (ActsOnMatch<T> || ActsOnRange<T>))
        MatchRequest(const T& request)
        : carry_out_(run<T>) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= max_bytes);
        std::memcpy(bytes_.data(), &request, sizeof(T));
    }

    void carry_out(RequestTarget& target) const {
        if (carry_out_ != nullptr) carry_out_(*this, target);
    }
    /// The request as a struct of type T; std::nullopt: the request is of another type.
    template <class T>
    std::optional<T> as() const {
        return carry_out_ == run<T> ? std::optional(value<T>()) : std::nullopt;
    }

private:
    template <class T>
    T value() const {
        T request{};
        std::memcpy(&request, bytes_.data(), sizeof(T));
        return request;
    }
    template <class T>
    static void run(const MatchRequest& request, RequestTarget& target) {
        if constexpr (ActsOnMatch<T>)
            request.value<T>().carry_out(target);
        else if (target.practice != nullptr)
            request.value<T>().carry_out(*target.practice);
    }

    std::array<std::byte, max_bytes> bytes_{};
    void (*carry_out_)(const MatchRequest&,
                       RequestTarget&) = nullptr;  ///< null: the request asks for nothing
};

}  // namespace thaum::game::inline range
