// input/detail/header_parts.h: lists and records of a log's header, and the parts that all formats share.
//
// A record is a value with a tag and its size. A reader can therefore skip a record that it does not know,
// and a later version adds values without a new format. A record that changes the match is marked as needed,
// so that no older reader skips it by mistake.
#pragma once
#include <cstring>

#include "core/bytes.h"
#include "core/text.h"
#include "input/log.h"

namespace thaum::input::detail {

// Lists --------------------------------------------------------------------------------------------

template <class T, class Put>
void put_list(ByteWriter& out, const std::vector<T>& list, Put put) {
    out.put(static_cast<std::uint32_t>(list.size()));
    for (const auto& item : list) put(item);
}

inline void put_strings(ByteWriter& out, const std::vector<std::string>& list) {
    put_list(out, list, [&](const std::string& s) { out.put_string(s); });
}

/// Reads a list of at most `most` items. Stops at the first missing item, so a wrong count costs nothing.
template <class Get>
auto get_list(ByteReader& in, std::size_t most, Get get) {
    std::vector<decltype(get())> list;
    const auto count = in.get<std::uint32_t>();
    if (count > most) in.reject();
    for (std::uint32_t i = 0; i < count && in.ok(); ++i) list.push_back(get());
    return list;
}

inline std::vector<std::string> get_strings(ByteReader& in, std::size_t most) {
    return get_list(in, most, [&] { return in.get_string(); });
}

inline DataFile get_file(ByteReader& in) {
    auto name = in.get_string();
    const auto hash = in.get<std::uint64_t>();
    return DataFile{std::move(name), hash};
}

/// Reads program, rules and seed of a match, which come in the same order in every format.
inline void get_match(ByteReader& in, LogHeader& h) {
    h.program = in.get_string();
    h.rules_version = in.get<std::uint32_t>();
    h.rule_set = in.get_string();
    h.arena = in.get_string();
    h.seed = in.get<std::uint64_t>();
    h.maths_probe = in.get<std::uint64_t>();
}

// Records ------------------------------------------------------------------------------------------

/// Flag of a record: a reader that does not know the tag must refuse the log.
inline constexpr std::uint16_t needed = 1;

/// Appends a record: tag, flags, size, and the bytes that `put` writes.
template <class Tag, class Put>
void put_record(Bytes& out, Tag tag, std::uint16_t flags, Put put) {
    ByteWriter writer(out);
    writer.put(tag);
    writer.put(flags);
    writer.put(std::uint32_t{});  // placeholder for the size, which is filled in below
    const auto begin = out.size();
    put(writer);
    const auto size = static_cast<std::uint32_t>(out.size() - begin);
    std::memcpy(out.data() + begin - sizeof size, &size, sizeof size);
}

/// Reads records to the end of `in`. `take(tag, content)` reads one record and returns
/// whether it knows the tag. Returns the first fault; empty if there is none. `what` names a
/// record in the fault, such as "section".
template <class Take>
std::string read_records(ByteReader& in, std::string_view what, Take take) {
    std::uint16_t before = 0;
    while (in.left() != 0) {
        const auto tag = in.get<std::uint16_t>();
        const auto flags = in.get<std::uint16_t>();
        ByteReader content(in.get_bytes(in.get<std::uint32_t>()));
        if (!in.ok()) return text("a ", what, " is cut off");
        if (tag <= before) return text(what, " ", tag, " follows ", what, " ", before);
        if ((flags & ~needed) != 0) return text(what, " ", tag, " has an unknown flag");
        before = tag;
        const bool known = take(tag, content);
        if (!known && (flags & needed) != 0)
            return text(what, " ", tag, " is unknown to this program and needed: use a newer Thaum");
        if (known && (!content.ok() || content.left() != 0)) return text(what, " ", tag, " is malformed");
    }
    return {};
}

}  // namespace thaum::input::detail
