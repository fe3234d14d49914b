// render/detail/key_labels.h: the characters that the user's keyboard layout assigns to keys.
#pragma once

namespace thaum::render {

/// Reads the labels for key_label from the window system. The layout may change while the window is open.
/// Called on the main thread while a window is open.
void read_key_labels();

}  // namespace thaum::render
