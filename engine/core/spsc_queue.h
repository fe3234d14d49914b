// core/spsc_queue.h: a queue of fixed capacity from one thread to another. Neither thread ever waits. If the
// queue is full, `push` drops the value and returns false.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

namespace thaum {

/// Queue of at most N values for one writing and one reading thread.
template <class T, std::size_t N>
class SpscQueue {
public:
    // The next function belongs to the writing thread.
    /// Adds a value. Returns false if the queue is full.
    bool push(const T& value) {
        const auto end = end_.load(std::memory_order_relaxed);
        if (end - begin_.load(std::memory_order_acquire) == N) return false;
        values_[end % N] = value;
        end_.store(end + 1, std::memory_order_release);
        return true;
    }

    // The next functions belong to the reading thread.
    /// Returns the oldest value, valid until `pop`; null if the queue is empty.
    const T* front() const {
        const auto begin = begin_.load(std::memory_order_relaxed);
        return begin == end_.load(std::memory_order_acquire) ? nullptr : &values_[begin % N];
    }
    /// Removes the oldest value. The queue must not be empty.
    void pop() { begin_.store(begin_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }
    /// Number of values in the queue. The writer may add more at any time.
    std::size_t size() const {
        return static_cast<std::size_t>(end_.load(std::memory_order_acquire) -
                                        begin_.load(std::memory_order_relaxed));
    }

private:
    std::array<T, N> values_{};
    std::atomic<std::uint64_t> begin_{0}, end_{0};
};

}  // namespace thaum
