#include "render/detail/screen_part.h"

#include <algorithm>
#include <cmath>

namespace thaum::render::detail {

Rect screen_part(fvec3 low, fvec3 high, const fmat4& to_clip, const Rect& view) {
    fvec2 least(1), most(-1);
    for (int corner = 0; corner < 8; ++corner) {
        const fvec3 p((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                      (corner & 4) != 0 ? high.z : low.z);
        const fvec4 clip = to_clip * fvec4(p, 1);
        if (!(clip.w > 1e-3F)) return view;
        least = glm::min(least, fvec2(clip) / clip.w);
        most = glm::max(most, fvec2(clip) / clip.w);
    }
    least = glm::clamp(least, -1.0F, 1.0F);
    most = glm::clamp(most, -1.0F, 1.0F);
    const auto pixel = [](float at, int length) { return (0.5F * at + 0.5F) * static_cast<float>(length); };
    const int x0 = std::max(static_cast<int>(std::floor(pixel(least.x, view.width))) - 1, 0),
              y0 = std::max(static_cast<int>(std::floor(pixel(least.y, view.height))) - 1, 0),
              x1 = std::min(static_cast<int>(std::ceil(pixel(most.x, view.width))) + 1, view.width),
              y1 = std::min(static_cast<int>(std::ceil(pixel(most.y, view.height))) + 1, view.height);
    if (most.x <= least.x || most.y <= least.y) return {};
    return {view.x + x0, view.y + y0, x1 - x0, y1 - y0};
}

}  // namespace thaum::render::detail
