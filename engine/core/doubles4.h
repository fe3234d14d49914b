// core/doubles4.h: vectors of four doubles. They are explicit because a compiler vectorises a loop only if it
// can prove that this is safe. The arithmetic is that of double on every processor.
#pragma once
#include <cstdint>
#include <cstring>

namespace thaum {

/// Four numbers of one vector register, or of two if the processor has no larger ones.
using Doubles4 = double __attribute__((vector_size(32)));
/// Four integers, as comparisons of Doubles4 give them: where a comparison holds, all bits of the integer are
/// set.
using Integers4 = std::int64_t __attribute__((vector_size(32)));

/// The same number in each lane.
inline Doubles4 all_four(double value) { return Doubles4{value, value, value, value}; }

/// Reads four numbers; the address needs no alignment.
template <class Four, class Number>
Four four_at(const Number* from) {
    Four four;
    std::memcpy(&four, from, sizeof four);
    return four;
}

/// Writes four numbers to any address.
template <class Four, class Number>
void put_four(Number* to, const Four& four) {
    std::memcpy(to, &four, sizeof four);
}

}  // namespace thaum
