// core/ring.h: a queue of fixed length from one thread to one other. Neither ever waits; what finds no room is left out, and the
// writer is told.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

namespace thaum {

template <class T, std::size_t N>
class Ring {
public:
    // The writer.
    /// False where there is no room.
    bool push(const T& value) {
        const auto end = end_.load(std::memory_order_relaxed);
        if (end - begin_.load(std::memory_order_acquire) == N) return false;
        values_[end % N] = value;
        end_.store(end + 1, std::memory_order_release);
        return true;
    }

    // The reader.
    /// The oldest, until it is popped; null where there is none.
    const T* front() const {
        const auto begin = begin_.load(std::memory_order_relaxed);
        return begin == end_.load(std::memory_order_acquire) ? nullptr : &values_[begin % N];
    }
    /// Only where there is a front.
    void pop() { begin_.store(begin_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }
    std::size_t size() const {
        return static_cast<std::size_t>(end_.load(std::memory_order_acquire) -
                                        begin_.load(std::memory_order_relaxed));
    }

private:
    std::array<T, N> values_{};
    std::atomic<std::uint64_t> begin_{0}, end_{0};
};

}  // namespace thaum
