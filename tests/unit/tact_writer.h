// unit/tact_writer.h: writes clips as bHaptics' designer does, to test the reader of such files.
#pragma once
#include <string>

#include "tactile/clip.h"

namespace thaum::tactile {

/// Writes a clip as the text of a .tact file, with tracks and with frames. Reading the text gives the same
/// clip.
std::string tact_of(const Clip& clip);

}  // namespace thaum::tactile
