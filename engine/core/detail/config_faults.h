// core/detail/config_faults.h: the faults of one data file, and the order in which they are reported.
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
    told      ///< a fault that the reader found and worded, such as two values that contradict each other
};

struct ConfigFault {
    FaultKind kind{};
    bool misleads = false;  ///< true: the reader cannot know which keys belong to the table
    const void* table{};    ///< table that holds the key; null: the whole file
    std::string key;
    std::size_t line{};  ///< line of the fault; 0: unknown
    std::string message;
    bool operator==(const ConfigFault&) const = default;
};

/// A key that no reader asked for.
struct UnknownKey {
    const void* table{};
    std::string key;
    std::string path;  ///< path of the key through its tables, such as "shot.damage"
    std::size_t line{};
};

/// For each table, by its address, the keys that readers asked for.
using AskedKeys = std::map<const void*, std::set<std::string, std::less<>>>;

/// All messages about a file, in the most helpful order. An unknown key comes before the missing key that was
/// probably meant; if the two differ by a typing mistake only, it replaces the missing one. In a table whose
/// reader was misled by another fault, other unknown keys are left out, because they may be correct.
/// std::nullopt: no fault.
std::optional<Error> told_faults(const std::string& file, const std::vector<ConfigFault>& faults,
                                 const std::vector<UnknownKey>& unknown, const AskedKeys& asked);

}  // namespace thaum::detail
