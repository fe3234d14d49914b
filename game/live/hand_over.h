// game/live/hand_over.h: passes one value at a time from one thread to another. A value that was not taken
// yet is replaced by the next one.
#pragma once
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

namespace thaum::game::inline live {

template <class T>
class HandOver {
public:
    void put(T value) {
        const std::lock_guard lock(mutex_);
        value_ = std::move(value);
        full_ = true;
    }
    /// Returns the newest value, once; std::nullopt if there is no new one. Takes no lock in that case.
    std::optional<T> take() {
        if (!full_) return {};
        const std::lock_guard lock(mutex_);
        full_ = false;
        return std::exchange(value_, std::nullopt);
    }

private:
    std::atomic<bool> full_{false};
    std::mutex mutex_;
    std::optional<T> value_{};
};

}  // namespace thaum::game::inline live
