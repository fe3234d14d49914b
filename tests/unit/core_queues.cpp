// Tests of SpscQueue and TripleBuffer between two threads. The thread sanitizer runs them, too.
#include <gtest/gtest.h>

#include <thread>

#include "core/spsc_queue.h"
#include "core/triple_buffer.h"

namespace thaum {
namespace {

constexpr std::uint64_t values = 200'000;

/// A value of several words, each of which follows from its number. If a value is read while it is written,
/// the words disagree.
struct Value {
    std::uint64_t number{};
    std::array<std::uint64_t, 4> products{};

    static Value of(std::uint64_t number) {
        Value value{number, {}};
        for (std::size_t i = 0; i < value.products.size(); ++i) value.products[i] = number * (i + 2);
        return value;
    }
    bool is_consistent() const { return products == of(number).products; }
};

TEST(SpscQueue, IsEmptyThenFullThenEmpty) {
    SpscQueue<int, 3> queue;
    EXPECT_EQ(queue.front(), nullptr);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(queue.push(i));
    EXPECT_FALSE(queue.push(3)) << "the queue is full";
    EXPECT_EQ(queue.size(), 3U);
    for (int i = 0; i < 3; ++i) {
        ASSERT_NE(queue.front(), nullptr);
        EXPECT_EQ(*queue.front(), i);
        queue.pop();
    }
    EXPECT_EQ(queue.front(), nullptr);
    EXPECT_EQ(queue.size(), 0U);
}

TEST(SpscQueue, PassesEveryValueInOrderFromThreadToThread) {
    SpscQueue<Value, 16> queue;
    std::jthread writer([&] {
        for (std::uint64_t n = 1; n <= values;) {
            if (queue.push(Value::of(n)))
                ++n;
            else
                std::this_thread::yield();
        }
    });
    for (std::uint64_t n = 1; n <= values;) {
        const auto* value = queue.front();
        if (value == nullptr) {
            std::this_thread::yield();
            continue;
        }
        ASSERT_EQ(value->number, n);
        ASSERT_TRUE(value->is_consistent());
        queue.pop();
        ++n;
    }
    EXPECT_EQ(queue.front(), nullptr);
}

TEST(TripleBuffer, HasItsFirstValueUntilOneIsPublished) {
    TripleBuffer<int> buffer(7);
    EXPECT_FALSE(buffer.take());
    EXPECT_EQ(buffer.newest(), 7);
    buffer.to_fill() = 8;
    EXPECT_FALSE(buffer.take()) << "the value is not published yet";
    buffer.publish();
    buffer.to_fill() = 9;
    buffer.publish();
    EXPECT_TRUE(buffer.take());
    EXPECT_EQ(buffer.newest(), 9);
    EXPECT_FALSE(buffer.take()) << "the value is taken already";
    EXPECT_EQ(buffer.newest(), 9);
}

TEST(TripleBuffer, PassesWholeValuesFromThreadToThreadAndTheLastForSure) {
    TripleBuffer<Value> buffer(Value::of(0));
    std::jthread writer([&] {
        for (std::uint64_t n = 1; n <= values; ++n) {
            buffer.to_fill() = Value::of(n);
            buffer.publish();
        }
    });
    for (std::uint64_t last = 0; last < values;) {
        if (!buffer.take()) {
            std::this_thread::yield();
            continue;
        }
        ASSERT_GT(buffer.newest().number, last);
        ASSERT_TRUE(buffer.newest().is_consistent());
        last = buffer.newest().number;
    }
}

}  // namespace
}  // namespace thaum
