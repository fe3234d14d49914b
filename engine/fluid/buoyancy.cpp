#include "fluid/buoyancy.h"

namespace thaum::fluid {
namespace {

/// Advection of one row of values across one axis; the change is multiplied by -2 h (m/s).
struct AxisAdvection {
    const float* velocity;
    const float* open;  ///< null: all faces are open
    std::ptrdiff_t step;

    Floats8 flow(std::ptrdiff_t i) const {
        return open != nullptr ? load(velocity + i) * load(open + i) : load(velocity + i);
    }
    Floats8 change(const float* value, std::ptrdiff_t i) const {
        const Floats8 here = load(value + i);
        return flow(i + step) * (load(value + i + step) - here) + flow(i) * (here - load(value + i - step));
    }
};

}  // namespace

void predict_weight(const Rows& rows, const std::array<Samples, 3>& velocity,
                    const std::array<Samples, 3>* open, double time, const Samples& weight, Samples& moved) {
    const auto part = static_cast<float>(time / (2 * rows.lattice.h));
    each_row(rows, [&](Row row) {
        const auto across = [&](std::size_t axis) {
            return AxisAdvection{velocity[axis].data() + row.at,
                                 open != nullptr ? (*open)[axis].data() + row.at : nullptr,
                                 rows.lattice.stride[axis]};
        };
        const AxisAdvection x = across(0), y = across(1), z = across(2);
        const float* value = weight.data() + row.at;
        for (std::ptrdiff_t i = 0; i < row.count; i += 8) {
            const Floats8 change = (x.change(value, i) + y.change(value, i)) + z.change(value, i);
            store(moved.data() + row.at + i, load(value + i) - part * change);
        }
    });
}

double lifted_by_diffusion(const Rows& rows, const std::array<Samples, 3>* open, const vec3& gravity,
                           const Samples& weight) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double pull = gravity[static_cast<int>(axis)];
        if (pull == 0) continue;
        const std::ptrdiff_t step = rows.lattice.stride[axis];
        double rise = 0;
        each_row(rows, [&](Row row) {
            const float* value = weight.data() + row.at;
            const float* share = open != nullptr ? (*open)[axis].data() + row.at : nullptr;
            for (std::ptrdiff_t i = 0; i < row.count; ++i) {
                const double jump = static_cast<double>(value[i]) - static_cast<double>(value[i - step]);
                rise += share != nullptr ? static_cast<double>(share[i]) * jump : jump;
            }
        });
        sum += pull * rise;
    }
    return sum / rows.lattice.h;
}

}  // namespace thaum::fluid
