// core/detail/config_faults.h: faults of one data file, and the order in which they are told.
#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"

namespace thaum::detail {

enum class FaultKind : std::uint8_t {
    value,    ///< a value of a wrong kind, out of its range, or none of the allowed words
    missing,  ///< a key or a table that is not there
    told      ///< found by the reader, such as two values that contradict each other
};

struct ConfigFault {
    FaultKind kind{};
    bool misleads = false;  ///< the reader cannot know which keys belong to the table
    const void* table{};    ///< table that holds the key; null: the whole file
    std::string key;
    std::size_t line{};  ///< 0: no line
    std::string message;
    bool operator==(const ConfigFault&) const = default;
};

/// A key that no reader asked for.
struct UnknownKey {
    const void* table{};
    std::string key;
    std::string path;  ///< the key after those of its tables: "shot.damage"
    std::size_t line{};
};

/// Keys that readers asked for, by table.
using AskedKeys = std::map<const void*, std::set<std::string, std::less<>>>;

/// All lines about a file in the order in which they help: a key that is unknown stands before the one that is
/// missing for it, or in its place if only a slip of typing lies between them. In a table whose reader was misled by
/// another fault, other unknown keys are left out: they may be right. std::nullopt: no fault.
std::optional<Error> told_faults(const std::string& file, const std::vector<ConfigFault>& faults,
                                 const std::vector<UnknownKey>& unknown, const AskedKeys& asked);

}  // namespace thaum::detail
