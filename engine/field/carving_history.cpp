#include "field/carving_history.h"

#include <cstring>

#include "core/assert.h"

namespace thaum::field {
namespace {

VoxelBox box_of(const VoxelView& body, std::uint32_t brick) {
    const auto& count = body.bricks->count;
    const int n = static_cast<int>(brick);
    return brick_box(body.count, {n % count[0], n / count[0] % count[1], n / (count[0] * count[1])});
}

/// For each property of a brick (block of voxels), and each row of its voxels, calls visit(row in the copy,
/// row in the body, number of elements).
template <class Copy, class Visit>
void for_each_run(Copy& copy, const VoxelView& body, Visit visit) {
    const VoxelBox box = box_of(body, copy.brick);
    const auto width = static_cast<std::size_t>(box.high[0] - box.low[0]);
    for_each_row(body, box, [&](std::size_t first, std::size_t row) {
        const std::size_t at = row * width;
        visit(&copy.density[at], &body.density[first], width);
        visit(&copy.colour[at], &body.colour[first], width);
        visit(&copy.material[at], &body.material[first], width);
    });
}

BrickCopy& copy_at(CarvingHistory& history, std::uint64_t number) {
    return history.ring[static_cast<std::size_t>(number % history.capacity)];
}

/// Adds a copy of a brick (block of voxels) at the end of the ring buffer. The buffer grows up to its
/// capacity, so that unused memory is never touched.
BrickCopy& new_copy(CarvingHistory& history) {
    const std::uint64_t number = history.next++;
    if (number % history.capacity == history.ring.size()) history.ring.emplace_back();
    return copy_at(history, number);
}

void store(BrickCopy& copy, const VoxelView& body, std::size_t brick) {
    copy.brick = static_cast<std::uint32_t>(brick);
    for_each_run(copy, body,
                 [](auto* kept, const auto* current, std::size_t n) { std::copy_n(current, n, kept); });
}

void exchange(BrickCopy& copy, const VoxelView& body) {
    for_each_run(copy, body,
                 [](auto* kept, auto* current, std::size_t n) { std::swap_ranges(kept, kept + n, current); });
}

/// Whether a brick (block of voxels) still equals its copy. Compares bits, so that a density that is NaN
/// equals itself.
bool is_unchanged(const BrickCopy& copy, const VoxelView& body) {
    bool same = true;
    for_each_run(copy, body, [&](const auto* kept, const auto* current, std::size_t n) {
        same = same && std::memcmp(kept, current, n * sizeof *kept) == 0;
    });
    return same;
}

void forget_all(CarvingHistory& history) {
    history.steps.clear();
    history.done = 0;
    history.open = false;
}

/// Opens a step (the record of a stroke) after all others. Steps that can be redone are kept until the new
/// step has changed something.
void open_step(CarvingHistory& history) {
    history.next = history.steps.empty() ? 0 : history.steps.back().first + history.steps.back().count;
    history.steps.push_back({history.next, 0});
    history.open = true;
    ++history.mark;
}

/// Forgets the steps (strokes) that could be redone, but not the open step after them. The open step then
/// counts as the last step that is done.
void forget_redo(CarvingHistory& history) {
    if (!history.open || history.done == history.steps.size()) return;
    const auto from = history.steps.begin() + static_cast<std::ptrdiff_t>(history.done);
    history.steps.erase(from, history.steps.end() - 1);
    history.done = history.steps.size();
    CarvingStep& step = history.steps.back();
    if (step.count > 0) return;
    step.first = history.done == 1 ? 0 : history.steps.end()[-2].first + history.steps.end()[-2].count;
    history.next = step.first;
}

std::uint64_t missing_copies(const CarvingHistory& history, const VoxelView& body, const VoxelBox& bricks) {
    std::uint64_t missing = 0;
    for_each_brick(*body.bricks, bricks, [&](std::array<int, 3>, std::size_t brick) {
        missing += history.kept_in[brick] == history.mark ? 0 : 1;
    });
    return missing;
}

/// Forgets steps (records of strokes) until this many more copies of bricks fit in memory: first those that
/// could be redone, then the oldest ones. Returns false if even the open step itself had to be forgotten.
bool make_room(CarvingHistory& history, std::uint64_t copies) {
    const auto is_full = [&] {
        return history.next - history.steps.front().first + copies > history.capacity;
    };
    if (is_full()) forget_redo(history);
    while (is_full()) {
        if (history.steps.size() == 1) return false;
        history.steps.pop_front();
        --history.done;
    }
    return true;
}

/// Exchanges the bricks (blocks of voxels) that a step (the record of a stroke) holds with those of the body,
/// which undoes the step or redoes it. Returns a box around these bricks.
VoxelBox exchange(CarvingHistory& history, const CarvingStep& step, const VoxelView& body) {
    VoxelBox changed;
    Bricks& bricks = *body.bricks;
    ++bricks.newest;
    for (std::uint64_t n = step.first; n < step.first + step.count; ++n) {
        BrickCopy& copy = copy_at(history, n);
        exchange(copy, body);
        bricks.version[copy.brick] = bricks.newest;
        changed = around(changed, box_of(body, copy.brick));
    }
    return changed;
}

/// Drops the copies of bricks (blocks of voxels) that did not change from the open step (the record of the
/// current stroke), and the step itself if no copy is left.
void drop_unchanged(CarvingHistory& history, const VoxelView& body) {
    CarvingStep& step = history.steps.back();
    std::uint64_t changed = 0;
    for (std::uint64_t n = step.first; n < step.first + step.count; ++n) {
        if (is_unchanged(copy_at(history, n), body)) continue;
        if (step.first + changed != n) copy_at(history, step.first + changed) = copy_at(history, n);
        ++changed;
    }
    step.count = changed;
    history.next = step.first + changed;
    if (changed > 0) return forget_redo(history);
    const bool was_done = history.done == history.steps.size();
    history.steps.pop_back();
    if (was_done) --history.done;
}

}  // namespace

CarvingHistory make_history(const VoxelView& body, std::size_t bytes) {
    CarvingHistory history{.capacity = std::max<std::size_t>(bytes / sizeof(BrickCopy), 1)};
    history.ring.reserve(history.capacity);
    history.kept_in.assign(body.bricks->version.size(), history.mark);
    return history;
}

void keep(CarvingHistory& history, const VoxelView& body, const VoxelBox& box) {
    THAUM_ASSERT(history.kept_in.size() == body.bricks->version.size(), "a history of another body");
    if (box.empty()) return;
    const VoxelBox bricks = bricks_around(box);
    if (!history.open) open_step(history);
    if (!make_room(history, missing_copies(history, body, bricks))) {
        forget_all(history);
        open_step(history);
        if (!make_room(history, missing_copies(history, body, bricks))) return forget_all(history);
    }
    for_each_brick(*body.bricks, bricks, [&](std::array<int, 3>, std::size_t brick) {
        if (history.kept_in[brick] == history.mark) return;
        history.kept_in[brick] = history.mark;
        store(new_copy(history), body, brick);
        ++history.steps.back().count;
    });
}

void end_step(CarvingHistory& history, const VoxelView& body) {
    if (!history.open) return;
    drop_unchanged(history, body);
    history.open = false;
}

Edit edit(const VoxelView& body, const Tool& tool, const Dab& dab, CarvingHistory& history) {
    keep(history, body, reach(body, tool, dab));
    const Edit edited = edit(body, tool, dab);
    if (edited.voxels > 0) forget_redo(history);
    return edited;
}

VoxelBox undo(CarvingHistory& history, const VoxelView& body) {
    end_step(history, body);
    if (!can_undo(history)) return {};
    return exchange(history, history.steps[--history.done], body);
}

VoxelBox redo(CarvingHistory& history, const VoxelView& body) {
    end_step(history, body);
    if (!can_redo(history)) return {};
    return exchange(history, history.steps[history.done++], body);
}

}  // namespace thaum::field
