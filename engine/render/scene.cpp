#include "render/scene.h"

namespace thaum::render {

std::array<Rect, 2> split_window(int width, int height, Split split) {
    switch (split) {
        case Split::none: break;
        case Split::side_by_side: {
            const int left = width / 2;
            return {Rect{0, 0, left, height}, Rect{left, 0, width - left, height}};
        }
        case Split::top_bottom: {
            const int top = height / 2;
            return {Rect{0, 0, width, top}, Rect{0, top, width, height - top}};
        }
    }
    return {Rect{0, 0, width, height}, Rect{}};
}

}  // namespace thaum::render
