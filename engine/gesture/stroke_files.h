// gesture/stroke_files.h: loads files of strokes, sessions and labels (gesture/stroke_csv.h), gzipped or not.
#pragma once
#include <filesystem>

#include "core/bytes.h"
#include "core/error.h"
#include "gesture/stroke_csv.h"

namespace thaum::gesture {

/// Largest file, and largest text after unpacking (bytes).
inline constexpr std::size_t max_stroke_bytes = std::size_t{1} << 30U;

/// Reads a text file. A file that begins like gzip is unpacked, whatever its name.
Expected<std::string> load_text(const std::filesystem::path& path);

/// @{ Reads a file of strokes, of sessions (continuous motion) or of labels of sessions
/// (gesture/stroke_csv.h). The error names file, line and fault.
Expected<StrokeSet> load_strokes(const std::filesystem::path& path);
Expected<SessionSet> load_sessions(const std::filesystem::path& path);
Expected<std::vector<SessionLabel>> load_labels(const std::filesystem::path& path);
/// @}

}  // namespace thaum::gesture
