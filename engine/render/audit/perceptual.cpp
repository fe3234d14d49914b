#include "render/audit/perceptual.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/assert.h"
#include "render/colour.h"

namespace thaum::render {
namespace {

constexpr int tile = 16;  // side of the square tiles over which differences are averaged (px)

/// Linear light, three floats per pixel, in the layout of Image.
struct Light {
    int width{}, height{};
    std::vector<float> rgb;
    const float* at(int x, int y) const {
        const int cx = std::clamp(x, 0, width - 1), cy = std::clamp(y, 0, height - 1);
        return &rgb[3 * (static_cast<std::size_t>(cy) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(cx))];
    }
};

Light light_of(const Image& image) {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255));
    Light out{image.width, image.height, std::vector<float>(image.rgb.size())};
    std::transform(image.rgb.begin(), image.rgb.end(), out.rgb.begin(),
                   [&](auto byte) { return table[byte]; });
    return out;
}

std::vector<float> gaussian(double sigma) {
    const int reach = static_cast<int>(std::ceil(3 * sigma));
    std::vector<float> weights;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) sum += std::exp(-0.5 * i * i / (sigma * sigma));
    for (int i = -reach; i <= reach; ++i)
        weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / sum));
    return weights;
}

/// Blurs along one axis. Outside the picture, the pixels of its edge repeat.
Light blurred_along(const Light& in, const std::vector<float>& weights, int dx, int dy) {
    const int reach = static_cast<int>(weights.size() / 2);
    Light out{in.width, in.height, std::vector<float>(in.rgb.size())};
    auto* to = out.rgb.data();
    for (int y = 0; y < in.height; ++y) {
        for (int x = 0; x < in.width; ++x, to += 3) {
            const float* tap = weights.data();
            for (int i = -reach; i <= reach; ++i) {
                const float* from = in.at(x + i * dx, y + i * dy);
                const float weight = *tap++;
                for (int c = 0; c < 3; ++c) to[c] += weight * from[c];
            }
        }
    }
    return out;
}

Light blurred(const Light& in, double sigma) {
    if (sigma <= 0) return in;
    const auto weights = gaussian(sigma);
    return blurred_along(blurred_along(in, weights, 1, 0), weights, 0, 1);
}

double delta_e(const float* a, const float* b) {
    const Lab la = lab_of(a[0], a[1], a[2]), lb = lab_of(b[0], b[1], b[2]);
    return std::hypot(la.l - lb.l, la.a - lb.a, la.b - lb.b);
}

}  // namespace

Lab lab_of(double red, double green, double blue) {
    // Linear sRGB light to XYZ (IEC 61966-2-1), relative to the white of red = green = blue = 1.
    const double x = (0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.9505;
    const double y = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    const double z = (0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.0890;
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

PictureDistance distance(const Image& a, const Image& b, double sigma) {
    THAUM_ASSERT(a.width == b.width && a.height == b.height, "only pictures of one size can be compared");
    if (a.rgb.empty()) return {};
    const Light la = blurred(light_of(a), sigma), lb = blurred(light_of(b), sigma);
    PictureDistance out;
    double sum = 0;
    for (int top = 0; top < a.height; top += tile) {
        for (int left = 0; left < a.width; left += tile) {
            const int bottom = std::min(top + tile, a.height), right = std::min(left + tile, a.width);
            double of_tile = 0;
            for (int y = top; y < bottom; ++y) {
                for (int x = left; x < right; ++x) of_tile += delta_e(la.at(x, y), lb.at(x, y));
            }
            sum += of_tile;
            out.worst = std::max(out.worst, of_tile / ((bottom - top) * (right - left)));
        }
    }
    out.mean = sum / (static_cast<double>(a.width) * a.height);
    return out;
}

}  // namespace thaum::render
