#include "fluid/momentum.h"

namespace thaum::fluid {
namespace {

/// The carrying velocity between a place and the one before it, `step` away; order 4: times 16 / 9, order 2: times 2.
template <bool fourth>
void interpolate_row(const float* u, std::ptrdiff_t step, std::ptrdiff_t count, float* out) {
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        out[i] = u[i - step] + u[i];
        if constexpr (fourth) out[i] -= (1.0F / 9) * (u[i - 2 * step] + u[i + step]);
    }
}

/// Rows of the carrying velocity round a row of what is carried: one before it, its own low side, its high side, one after that.
struct Carrier {
    const float* before;
    const float* low;
    const float* high;
    const float* after;
    std::ptrdiff_t step;  ///< to the next place along it, in what is carried
};

/// What flows out to the next places and in from those before them.
inline float near_flux(const Carrier& by, const float* q, std::ptrdiff_t i) {
    return by.high[i] * q[i + by.step] - by.low[i] * q[i - by.step];
}
inline float far_flux(const Carrier& by, const float* q, std::ptrdiff_t i) {
    return by.after[i] * q[i + 3 * by.step] - by.before[i] * q[i - 3 * by.step];
}
inline float round_about(const float* q, std::ptrdiff_t i, std::ptrdiff_t step) {
    return q[i - step] + q[i + step];
}

/// The component's own axis apart from the other two, whose sum comes first: so that exchanging these changes no bit.
template <bool fourth, bool viscous>
void rate_row(const Carrier& a, const Carrier& b, const Carrier& c, const float* q, std::ptrdiff_t count,
              float h, float viscosity, float* rate) {
    const float near = -(fourth ? 81.0F / 256 : 0.25F) / h;
    const float far = 9.0F / 768 / h;
    const float spread = viscosity / (h * h);
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        float sum = near * (near_flux(a, q, i) + (near_flux(b, q, i) + near_flux(c, q, i)));
        if constexpr (fourth) sum += far * (far_flux(a, q, i) + (far_flux(b, q, i) + far_flux(c, q, i)));
        if constexpr (viscous) {
            const float ones =
                round_about(q, i, a.step) + (round_about(q, i, b.step) + round_about(q, i, c.step));
            if constexpr (fourth) {
                const float twos = round_about(q, i, 2 * a.step) +
                                   (round_about(q, i, 2 * b.step) + round_about(q, i, 2 * c.step));
                sum += spread * ((4.0F / 3 * ones - 1.0F / 12 * twos) - 7.5F * q[i]);
            } else {
                sum += spread * (ones - 6 * q[i]);
            }
        }
        rate[i] = sum;
    }
}

void add_row(const Stage& stage, std::size_t axis, std::ptrdiff_t at, std::ptrdiff_t count, float* rate) {
    const float* start = stage.start[axis].data() + at;
    float* sum = stage.sum[axis].data() + at;
    if (stage.force != nullptr) {
        const float* force = (*stage.force)[axis].data() + at;
#pragma GCC ivdep
        for (std::ptrdiff_t i = 0; i < count; ++i) rate[i] += force[i];
    }
    const float* before = stage.first ? start : sum;
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) sum[i] = before[i] + stage.sum_part * rate[i];
    if (stage.next == nullptr) return;
    float* next = (*stage.next)[axis].data() + at;
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) next[i] = start[i] + stage.next_part * rate[i];
}

}  // namespace

Momentum::Momentum(const Lattice& lattice, int order)
    : lattice_(lattice), order_(order), row_(static_cast<std::size_t>(lattice.stride[1])) {
    for (auto& plane : planes_) plane.resize(static_cast<std::size_t>(lattice.stride[2]) + 8);
}

template <bool fourth, bool viscous>
void Momentum::component(const Stage& stage, std::size_t axis, float viscosity) {
    const auto& [nx, ny, nz] = lattice_.cells;
    const auto& stride = lattice_.stride;
    const auto along = stride[axis];
    const auto in_plane = [&](int i, int j) { return (j + ghosts) * stride[1] + i + ghosts; };
    const auto ring = [&](int k) { return planes_[2 + static_cast<std::size_t>(k + 1) % 4].data(); };
    const auto lift = [&](int k) {
        for (int j = 0; j < ny; ++j)
            interpolate_row<fourth>(stage.from[2].data() + lattice_.at(0, j, k), along, nx,
                                    ring(k) + in_plane(0, j));
    };
    for (int k = -1; k < 2; ++k) lift(k);
    for (int k = 0; k < nz; ++k) {
        lift(k + 2);
        for (int j = 0; j < ny; ++j)
            interpolate_row<fourth>(stage.from[0].data() + lattice_.at(-1, j, k), along, nx + 3,
                                    planes_[0].data() + in_plane(-1, j));
        for (int j = -1; j < ny + 2; ++j)
            interpolate_row<fourth>(stage.from[1].data() + lattice_.at(0, j, k), along, nx,
                                    planes_[1].data() + in_plane(0, j));
        for (int j = 0; j < ny; ++j) {
            const auto here = in_plane(0, j);
            const float* x = planes_[0].data() + here;
            const float* y = planes_[1].data() + here;
            const std::array<Carrier, 3> by{
                Carrier{x - 1, x, x + 1, x + 2, 1},
                Carrier{y - stride[1], y, y + stride[1], y + 2 * stride[1], stride[1]},
                Carrier{ring(k - 1) + here, ring(k) + here, ring(k + 1) + here, ring(k + 2) + here,
                        stride[2]}};
            rate_row<fourth, viscous>(by[axis], by[(axis + 1) % 3], by[(axis + 2) % 3],
                                      stage.from[axis].data() + lattice_.at(0, j, k), nx,
                                      static_cast<float>(lattice_.h), viscosity, row_.data());
            add_row(stage, axis, lattice_.at(0, j, k), nx, row_.data());
        }
    }
}

void Momentum::take(const Stage& stage, double viscosity) {
    const auto nu = static_cast<float>(viscosity);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (order_ == 4 && nu > 0) component<true, true>(stage, axis, nu);
        if (order_ == 4 && nu <= 0) component<true, false>(stage, axis, nu);
        if (order_ == 2 && nu > 0) component<false, true>(stage, axis, nu);
        if (order_ == 2 && nu <= 0) component<false, false>(stage, axis, nu);
    }
}

}  // namespace thaum::fluid
