// render/priority.h: lowers the priority of drawing, and of background work. Software OpenGL takes every core
// it can get, so threads with deadlines must come first.
#pragma once

namespace thaum::render {

/// Lowers the priority of the calling thread, which draws, and of the rasteriser's own threads in this
/// process. Has no effect if the system refuses.
void draw_behind_others();

/// Lowers the priority of the calling thread alone. Has no effect if the system refuses.
void work_behind_others();

}  // namespace thaum::render
