// game/context/event_journal.h: every event of the last seconds of a match, for all code that shows or counts
// events.
//
// The World keeps only the last 64 events (EventLog), since each costs bytes in every saved state. A tick may
// record more: 100 missiles that hit together are 200 events. So readers take events from this journal, which
// loses none. Its memory is enough for 400 events per second. It grows when a match records more.
#pragma once
#include <cstdint>
#include <vector>

#include "core/units.h"
#include "game/components/match.h"

namespace thaum::game::inline context {

class EventJournal {
public:
    /// Minimum time for which events are kept (ticks of play).
    static constexpr Tick kept = ticks(10);

    EventJournal() : events_(4096) {}

    /// Adds the newest event. Allocates only if the buffer is full of events that are not yet old enough to
    /// drop.
    void add(const Event& event) {
        if (count_ - first_ == events_.size()) {
            if (events_[first_ & mask()].tick + kept < event.tick)
                ++first_;
            else
                grow();
        }
        events_[count_ & mask()] = event;
        ++count_;
    }

    /// Clears the journal, and takes over the events that a match restored from a saved state still contains.
    void restart(const EventLog& log) {
        const auto held = std::min<std::uint64_t>(log.count, log.events.size());
        count_ = first_ = log.count - held;
        while (count_ < log.count) add(log.events[count_ % log.events.size()]);
    }

    /// Number of events of the match so far, equal to EventLog::count.
    std::uint64_t count() const { return count_; }
    /// Number of the oldest event that is still in the journal.
    std::uint64_t first() const { return first_; }
    /// Event by its number, from first() up to count() - 1.
    const Event& operator[](std::uint64_t number) const { return events_[number & mask()]; }

    /// Calls f(event) for each event from number `seen` on, and advances `seen` to count(). Returns how many
    /// of these events were no longer in the journal: 0 for a reader that reads at least every `kept` ticks.
    template <class F>
    std::uint64_t each_new(std::uint64_t& seen, F f) const {
        const auto gone = std::max(seen, first_) - seen;
        for (seen += gone; seen < count_; ++seen) f((*this)[seen]);
        return gone;
    }

private:
    // Mask that turns an event's number into its place in the buffer, whose size is a power of two.
    std::uint64_t mask() const { return events_.size() - 1; }

    void grow() {
        std::vector<Event> larger(2 * events_.size());
        for (auto i = first_; i < count_; ++i) larger[i & (larger.size() - 1)] = events_[i & mask()];
        events_ = std::move(larger);
    }

    std::vector<Event> events_;
    std::uint64_t first_ = 0, count_ = 0;
};

}  // namespace thaum::game::inline context
