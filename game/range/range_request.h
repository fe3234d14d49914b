// game/range/range_request.h: a request to the practice on the range, as a value
// that one thread hands to another.
#pragma once
#include <array>
#include <cstddef>
#include <cstring>
#include <optional>
#include <type_traits>

namespace thaum::game::inline range {

class Practice;

/// Any small plain struct that has `void carry_out(Practice&) const`. The list of such structs is
/// open, so that neither the menu nor the session nor the simulation knows them: whoever asks names
/// the struct, and the struct acts.
class RangeRequest {
public:
    static constexpr std::size_t max_bytes = 8;

    /// A request that does nothing.
    RangeRequest() = default;
    template <class T>
    requires(!std::is_same_v<T, RangeRequest>) explicit RangeRequest(const T& request) : carry_out_(run<T>) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= max_bytes);
        std::memcpy(bytes_.data(), &request, sizeof(T));
    }

    void carry_out(Practice& practice) const {
        if (carry_out_ != nullptr) carry_out_(*this, practice);
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
    static void run(const RangeRequest& request, Practice& practice) {
        request.value<T>().carry_out(practice);
    }

    std::array<std::byte, max_bytes> bytes_{};
    void (*carry_out_)(const RangeRequest&, Practice&) = nullptr;  ///< null: the request asks for nothing
};

}  // namespace thaum::game::inline range
