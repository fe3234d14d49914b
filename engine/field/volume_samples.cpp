#include "field/volume_samples.h"

#include <algorithm>

namespace thaum::field {

std::vector<float>& VolumeSamples::floats() {
    if (!std::holds_alternative<std::vector<float>>(values)) values = as_floats();
    return std::get<std::vector<float>>(values);
}

std::vector<float> VolumeSamples::as_floats() const {
    return visit([](const auto& all) { return std::vector<float>(all.begin(), all.end()); });
}

bool VolumeSamples::operator==(const VolumeSamples& other) const {
    return visit([&](const auto& a) {
        return other.visit([&](const auto& b) {
            return std::ranges::equal(
                a, b, {}, [](auto n) { return static_cast<float>(n); },
                [](auto n) { return static_cast<float>(n); });
        });
    });
}

}  // namespace thaum::field
