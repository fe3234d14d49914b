// core/triple_buffer.h: passes the newest of a stream of values from one thread to another (a triple buffer).
//
// Neither thread ever waits: the writer fills one value, the reader reads another, and the third is exchanged
// between them.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

namespace thaum {

/// Three values of which one writing thread publishes the newest to one reading thread.
template <class T>
class TripleBuffer {
public:
    explicit TripleBuffer(const T& start) : values_{start, start, start} {}

    /// The value to fill next; it may hold anything that was published before. Called by the writer.
    T& to_fill() { return values_[back_]; }
    /// Hands the filled value to the reader. Called by the writer.
    void publish() { back_ = middle_.exchange(back_ | fresh, std::memory_order_acq_rel) & index; }

    // The next functions belong to the reading thread.
    /// Takes the newest value. Returns false if no newer value was published since the last call.
    bool take() {
        if ((middle_.load(std::memory_order_relaxed) & fresh) == 0) return false;
        front_ = middle_.exchange(front_, std::memory_order_acq_rel) & index;
        return true;
    }
    /// The value that the last successful `take` took; before the first one, a default-initialised value.
    const T& newest() const { return values_[front_]; }

private:
    static constexpr std::uint32_t index = 3, fresh = 4;
    std::array<T, 3> values_;
    std::uint32_t back_ = 0;
    std::atomic<std::uint32_t> middle_{1};
    std::uint32_t front_ = 2;
};

}  // namespace thaum
