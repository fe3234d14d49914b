#include "ecs/diff.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>

#include "core/text.h"
#include "ecs/component.h"
#include "ecs/snapshot.h"
#include "ecs/table.h"

// A snapshot is read by the description that it contains, without a World. So snapshots from other builds of
// the program can be compared.
namespace thaum::ecs {
namespace {

struct Described {
    std::string name;
    std::uint32_t size{};
    bool is_blob{};
    std::vector<FieldInfo> fields;
};

/// Bytes of each component of one entity, by the name of the component. A tag (a component without fields)
/// has no bytes.
using Parts = std::map<std::string, std::span<const std::byte>>;

struct Parsed {
    std::map<std::string, Described> components;
    std::map<std::uint32_t, Parts> entities;
    Parts blobs;
};

std::optional<std::vector<Described>> get_components(ByteReader& in) {
    const auto magic = in.get_bytes(snapshot_magic.size());
    if (!in.ok() || std::memcmp(magic.data(), snapshot_magic.data(), magic.size()) != 0) return {};
    if (in.get<std::uint32_t>() != snapshot_format) return {};
    std::vector<Described> result(std::min<std::size_t>(in.get<std::uint32_t>(), max_components));
    for (auto& c : result) {
        c.name = in.get_string();
        c.size = in.get<std::uint32_t>();
        c.is_blob = in.get<std::uint8_t>() != 0;
        if (c.is_blob && c.size == 0) return {};
        const auto fields = in.get<std::uint32_t>();
        for (std::uint32_t f = 0; f < fields && in.ok(); ++f) {
            FieldInfo field{in.get_string(), in.get<std::uint32_t>(), in.get<Scalar>()};
            const auto kind = static_cast<std::size_t>(field.scalar);
            if (kind >= scalar_sizes.size() || c.size < scalar_sizes[kind] ||
                field.offset > c.size - scalar_sizes[kind]) {
                return {};
            }
            c.fields.push_back(std::move(field));
        }
        // Each element of a blob (an array that no entity owns) is one number, so its description has one
        // field.
        if (c.is_blob && c.fields.size() != 1) return {};
    }
    if (!in.ok()) return {};
    return result;
}

bool get_table(ByteReader& in, const std::vector<Described>& components, Parsed& out) {
    Mask mask;
    for (auto& word : mask.words) word = in.get<std::uint64_t>();
    const auto rows = in.get<std::uint32_t>();
    std::vector<Parts*> parts;
    for (std::uint32_t row = 0; row < rows && in.ok(); ++row) {
        parts.push_back(&out.entities[in.get<std::uint32_t>()]);
        // Skips the generation (how often the number of the entity was used before), which the list of entity
        // records holds, too.
        in.get<std::uint32_t>();
    }
    for (std::uint32_t c = 0; c < max_components && in.ok(); ++c) {
        if (!mask.test(c)) continue;
        if (c >= components.size()) return false;
        for (std::uint32_t row = 0; row < rows && in.ok(); ++row) {
            (*parts[row])[components[c].name] = in.get_bytes(components[c].size);
        }
    }
    const auto tags = in.get<std::uint32_t>();
    for (std::uint32_t t = 0; t < tags && in.ok(); ++t) {
        const auto component = in.get<std::uint32_t>();
        if (component >= components.size()) return false;
        for (std::uint32_t row = 0; row < rows && in.ok(); row += 64) {
            const auto word = in.get<std::uint64_t>();
            for (std::uint32_t bit = 0; bit < 64 && row + bit < rows; ++bit) {
                if (((word >> bit) & 1U) != 0) (*parts[row + bit])[components[component].name] = {};
            }
        }
    }
    return in.ok();
}

bool get_blobs(ByteReader& in, const std::vector<Described>& components, Parsed& out) {
    for (const auto& c : components) {
        if (!c.is_blob) continue;
        const auto elements = in.get<std::uint64_t>();
        if (!in.ok() || elements > in.left() / c.size) return false;
        out.blobs[c.name] = in.get_bytes(elements * c.size);
    }
    return in.ok();
}

Expected<Parsed> parse(std::span<const std::byte> snapshot, std::string_view which) {
    ByteReader in(snapshot);
    Parsed result;
    const auto damaged = fail(text("state ", which, ": not a snapshot, or damaged"));
    const auto components = get_components(in);
    if (!components) return damaged;
    const auto records = in.get<std::uint32_t>();
    in.get_bytes(std::size_t{records} * 12);
    in.get<std::uint32_t>();
    const auto tables = in.get<std::uint32_t>();
    for (std::uint32_t t = 0; t < tables; ++t) {
        if (!in.ok() || !get_table(in, *components, result)) return damaged;
    }
    if (!in.ok() || !get_blobs(in, *components, result)) return damaged;
    for (const auto& c : *components) result.components[c.name] = c;
    return result;
}

template <class T>
std::string value_text(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    if constexpr (sizeof(T) == 1) return text(static_cast<int>(value));
    if constexpr (sizeof(T) > 1) return text(value);
}

std::string value_text(const std::byte* at, Scalar scalar) {
    switch (scalar) {
        case Scalar::f32: return value_text<float>(at);
        case Scalar::f64: return value_text<double>(at);
        case Scalar::i8: return value_text<std::int8_t>(at);
        case Scalar::i16: return value_text<std::int16_t>(at);
        case Scalar::i32: return value_text<std::int32_t>(at);
        case Scalar::i64: return value_text<std::int64_t>(at);
        case Scalar::u8: return value_text<std::uint8_t>(at);
        case Scalar::u16: return value_text<std::uint16_t>(at);
        case Scalar::u32: return value_text<std::uint32_t>(at);
        case Scalar::u64: return value_text<std::uint64_t>(at);
    }
    return "?";
}

const FieldInfo* field_named(const Described& c, std::string_view name) {
    const auto found =
        std::find_if(c.fields.begin(), c.fields.end(), [&](const auto& f) { return f.name == name; });
    return found == c.fields.end() ? nullptr : &*found;
}

/// Lists the fields of a component that differ, and those that it has in one snapshot alone.
void diff_fields(const Described& a, std::span<const std::byte> bytes_a, const Described& b,
                 std::span<const std::byte> bytes_b, std::uint32_t entity, std::vector<Difference>& out) {
    for (const auto& f : a.fields) {
        const auto* g = field_named(b, f.name);
        const auto size = scalar_sizes[static_cast<std::size_t>(f.scalar)];
        const bool same = g != nullptr && g->scalar == f.scalar &&
                          std::memcmp(bytes_a.data() + f.offset, bytes_b.data() + g->offset, size) == 0;
        if (same) continue;
        out.push_back({a.name, entity, f.name, value_text(bytes_a.data() + f.offset, f.scalar),
                       g == nullptr ? "-" : value_text(bytes_b.data() + g->offset, g->scalar)});
    }
    for (const auto& g : b.fields) {
        if (field_named(a, g.name) != nullptr) continue;
        out.push_back({a.name, entity, g.name, "-", value_text(bytes_b.data() + g.offset, g.scalar)});
    }
}

/// A blob (an array of numbers that no entity owns) in one snapshot. If the snapshot lacks it, `type` is null
/// and there are no bytes.
struct BlobOf {
    const Described* type{};
    std::span<const std::byte> bytes;
};

BlobOf blob_of(const Parsed& side, const std::string& name) {
    const auto found = side.blobs.find(name);
    if (found == side.blobs.end()) return {};
    return {&side.components.at(name), found->second};
}

std::size_t elements_of(const BlobOf& blob) {
    return blob.type == nullptr ? 0 : blob.bytes.size() / blob.type->size;
}

std::string element_text(const BlobOf& blob, std::size_t i) {
    const auto& number = blob.type->fields.front();
    return value_text(blob.bytes.data() + i * blob.type->size + number.offset, number.scalar);
}

/// Lists the elements of a blob (an array of numbers that no entity owns) that differ. A blob that one
/// snapshot lacks, or whose size differs, counts as one difference. If the types of the elements differ, so
/// does each element.
void diff_blob(const Parsed& a, const Parsed& b, const std::string& name, std::size_t limit,
               std::vector<Difference>& out) {
    const auto x = blob_of(a, name), y = blob_of(b, name);
    const auto elements = elements_of(x), others = elements_of(y);
    if (elements != others) {
        out.push_back({name, none, "", text(elements, " elements"), text(others, " elements")});
        return;
    }
    if (elements == 0) return;
    const auto size = x.type->size;
    const bool one_type =
        size == y.type->size && x.type->fields.front().scalar == y.type->fields.front().scalar;
    for (std::size_t i = 0; i < elements && out.size() < limit; ++i) {
        if (one_type && std::memcmp(x.bytes.data() + i * size, y.bytes.data() + i * size, size) == 0)
            continue;
        out.push_back({name, none, text("[", i, "]"), element_text(x, i), element_text(y, i)});
    }
}

void diff_blobs(const Parsed& a, const Parsed& b, std::size_t limit, std::vector<Difference>& out) {
    for (const auto& [name, bytes] : a.blobs) diff_blob(a, b, name, limit, out);
    for (const auto& [name, bytes] : b.blobs)
        if (!a.blobs.contains(name)) diff_blob(a, b, name, limit, out);
}

void diff_entity(const Parsed& a, const Parts* pa, const Parsed& b, const Parts* pb, std::uint32_t entity,
                 std::vector<Difference>& out) {
    if (pa == nullptr || pb == nullptr) {
        out.push_back({"", entity, "", pa != nullptr ? "exists" : "-", pb != nullptr ? "exists" : "-"});
        return;
    }
    for (const auto& [name, bytes] : *pa) {
        const auto other = pb->find(name);
        if (other == pb->end()) {
            out.push_back({name, entity, "", "present", "-"});
        } else {
            diff_fields(a.components.at(name), bytes, b.components.at(name), other->second, entity, out);
        }
    }
    for (const auto& [name, bytes] : *pb) {
        if (!pa->contains(name)) out.push_back({name, entity, "", "-", "present"});
    }
}

}  // namespace

Expected<std::vector<Difference>> diff(std::span<const std::byte> a, std::span<const std::byte> b,
                                       std::size_t limit) {
    const auto pa = parse(a, "A");
    if (!pa) return pa.error();
    const auto pb = parse(b, "B");
    if (!pb) return pb.error();
    std::vector<Difference> out;
    auto ia = pa->entities.begin();
    auto ib = pb->entities.begin();
    while ((ia != pa->entities.end() || ib != pb->entities.end()) && out.size() < limit) {
        const bool take_a = ib == pb->entities.end() || (ia != pa->entities.end() && ia->first <= ib->first);
        const bool take_b = ia == pa->entities.end() || (ib != pb->entities.end() && ib->first <= ia->first);
        const auto entity = take_a ? ia->first : ib->first;
        diff_entity(*pa, take_a ? &ia->second : nullptr, *pb, take_b ? &ib->second : nullptr, entity, out);
        if (take_a) ++ia;
        if (take_b) ++ib;
    }
    diff_blobs(*pa, *pb, limit, out);
    if (out.empty() && !std::equal(a.begin(), a.end(), b.begin(), b.end())) {
        out.push_back({"", 0, "order", "differs", "differs"});
    }
    if (out.size() > limit) out.resize(limit);
    return out;
}

}  // namespace thaum::ecs
