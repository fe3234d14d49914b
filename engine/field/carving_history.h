// field/carving_history.h: undo and redo of carving, equal in every bit.
//
//     edit(body, tool, dab, history)     any number of edits: a stroke
//     end_step(history, body)            the stroke ends
//     undo(history, body)                the body as before the stroke
//
// A step is the record of one stroke. It holds a copy of each brick (8 x 8 x 8 voxels) as it was before the
// stroke first changed it. Undo exchanges the copies with the bricks of the body, so the same step then
// serves for redo. Storing the edits instead would need less memory, but a filter (a gradual change) has no
// inverse.
//
// A copied brick takes 4 KB. If memory runs out, the oldest steps are forgotten. If a stroke alone needs more
// than all the memory, its beginning is forgotten, too: undo then returns to some moment within the stroke.
#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "field/carving.h"
#include "field/voxels.h"

namespace thaum::field {

/// Copy of the voxels of a brick (8 x 8 x 8 voxels), x fastest. A smaller brick at the far end of the body
/// uses only a part of it.
struct BrickCopy {
    std::uint32_t brick{};
    std::array<float, voxels_of_brick> density{};
    std::array<Rgb8, voxels_of_brick> colour{};
    std::array<std::uint8_t, voxels_of_brick> material{};
};

/// The copies of bricks that belong to one stroke; they lie side by side in the ring buffer.
struct CarvingStep {
    std::uint64_t first{};  ///< number of the first copy, counted over the whole life of the history
    std::uint64_t count{};
};

/// History of one body. Only the functions below change it.
struct CarvingHistory {
    /// Ring buffer of copied bricks; copy n is at index n modulo the capacity.
    std::vector<BrickCopy> ring{};
    std::uint64_t capacity{};  ///< number of copies that fit into the memory
    std::uint64_t next{};      ///< number that the next copy will have
    /// Steps (each the record of a stroke) that can be undone, then steps that can be redone, then an open
    /// step that has changed nothing yet.
    std::deque<CarvingStep> steps{};
    std::size_t done{};  ///< number of steps that can be undone
    bool open = false;   ///< true: a stroke goes on, and new edits belong to the last step
    /// Number of the open step (current stroke), with which `kept_in` marks the bricks that it has copied.
    std::uint32_t mark{};
    /// For each brick (block of voxels): mark of the last step (stroke) that has a copy of it.
    std::vector<std::uint32_t> kept_in{};
};

inline constexpr std::size_t usual_history_bytes = std::size_t{64} << 20U;

/// Makes an empty history. `bytes` limits its memory for copies of voxels. Address space is reserved at once,
/// but memory is used only as strokes need it.
CarvingHistory make_history(const VoxelView& body, std::size_t bytes = usual_history_bytes);

/// Ends the open step (the record of the current stroke), if there is one. Copies of bricks that did not
/// change are dropped, and the step with them if none is left: a stroke that touched nothing is no step.
/// Steps that could be redone are forgotten once a stroke has changed something.
void end_step(CarvingHistory& history, const VoxelView& body);

/// Copies the bricks (blocks of voxels) of the box before they are changed, except those that the open step
/// (the record of the current stroke) has copied already. Opens a step if none is open.
void keep(CarvingHistory& history, const VoxelView& body, const VoxelBox& box);

/// Applies a tool (field/carving.h) as a part of the open step (the record of the current stroke), so that it
/// can be undone.
Edit edit(const VoxelView& body, const Tool& tool, const Dab& dab, CarvingHistory& history);

/// Undoes the last step (a whole stroke of carving). Returns a box around all changed voxels, empty if there
/// is no such step. An open step is ended first.
VoxelBox undo(CarvingHistory& history, const VoxelView& body);
/// Redoes the step (stroke of carving) that was undone last. Returns a box around all changed voxels, empty
/// if there is no such step.
VoxelBox redo(CarvingHistory& history, const VoxelView& body);

/// Whether there is a stroke of carving to undo.
inline bool can_undo(const CarvingHistory& history) { return history.done > 0; }
/// Whether there is a stroke of carving to do again.
inline bool can_redo(const CarvingHistory& history) {
    return history.done + (history.open ? 1 : 0) < history.steps.size();
}

}  // namespace thaum::field
