// tactile/hjif.h: writes .hjif files, the readable form of MPEG haptics (ISO/IEC 23090-31).
//
// Written as the reference software reads it (MPEGGroup/HapticReferenceSoftware, IOJson): one perception of modality
// Vibrotactile, one channel for each actuator, in it one band of type VectorialWave with Basis effects, whose keyframes
// modulate amplitude and frequency. Times are in ms. The profile is Main at level 1, which allows 128 channels.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "tactile/frame.h"
#include "tactile/layout.h"

namespace thaum::tactile {

/// Frames of a layout as a .hjif file. `date` is an ISO 8601 date such as "2026-01-31".
std::string export_hjif(const Layout& layout, std::span<const TactileFrame> frames,
                        std::string_view description, std::string_view date);

}  // namespace thaum::tactile
