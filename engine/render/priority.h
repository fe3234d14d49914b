// render/priority.h: on software OpenGL drawing takes every core it can get; what must keep time goes first.
#pragma once

namespace thaum::render {

/// Lowers the priority of the calling thread, which draws, and of the rasteriser's own threads in this process. A wish: where
/// the system does not let it, nothing changes.
void draw_behind_others();

}  // namespace thaum::render
