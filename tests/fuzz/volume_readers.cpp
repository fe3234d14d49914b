// Fuzzes the readers of volumes: NRRD files with their samples, headers with samples in other files, and
// descriptions of raw samples. An accepted volume must be readable at every position, and must be the same
// after writing and reading it again.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/file.h"
#include "core/gzip.h"
#include "core/text.h"
#include "field/nrrd.h"
#include "field/volume_file.h"
#include "fuzz/fuzz.h"

namespace thaum::fuzz {
namespace {

/// Maximum number of samples that is read, so that a run stays short.
constexpr std::size_t max_read = std::size_t{1} << 20U;
constexpr std::size_t stored_count = 60;

/// Whether all bits are equal, so that NaN equals itself.
bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

bool is_integer_type(field::SampleType type) { return type < field::SampleType::float32; }

Outcome use_volume(const Expected<field::Volume>& volume, const Places& places) {
    if (!volume) return {.refusal = volume.error().message};
    std::size_t size = static_cast<std::size_t>(volume->components);
    for (const int n : volume->count) size *= static_cast<std::size_t>(n);
    if (size != volume->samples.size() || size == 0 || size > max_read)
        return {.fault = "a volume with a wrong number of samples"};
    if (!(glm::length(volume->spacing) < 1e4) || !is_finite(volume->placement.origin))
        return {.fault = "a volume without an extent"};
    for (const vec3 place : {vec3(0), vec3(-1e9, 1e9, 0.001), volume->place(0, 0, 0)}) {
        const double value = volume->grid()(place).value;
        if (is_integer_type(volume->stored_as) && !std::isfinite(value))
            return {.fault = "integers give NaN"};
    }
    const auto path = places.scratch / "again.nrrd";
    if (!field::write_nrrd(path, *volume, field::Packing::raw)) return {.fault = "it cannot be written"};
    const auto again = field::read_nrrd(path);
    if (!again) return {.fault = again.error().message};
    if (!same_bits(again->samples.as_floats(), volume->samples.as_floats()) || again->count != volume->count)
        return {.fault = "a volume that differs after it was written and read"};
    return {.accepted = true};
}

template <const char* const& name>
Outcome read_volume_file(const std::string& input, const Places& places) {
    const auto path = places.scratch / name;
    if (!write_text_file(path, input)) return {.fault = "the scratch folder cannot be written"};
    return use_volume(field::read_volume(path, {.limit = max_read}), places);
}

constexpr const char *nrrd = "volume.nrrd", *nhdr = "volume.nhdr", *toml = "volume.toml";

std::string stored_samples(std::size_t bytes) {
    std::string out(bytes, '\0');
    for (std::size_t i = 0; i < bytes; ++i) out[i] = static_cast<char>(i * 7);
    return out;
}

std::vector<std::string> nrrd_seeds(const Places&) {
    const std::string plain = stored_samples(2 * stored_count);
    const Bytes packed = pack_gzip(std::as_bytes(std::span(plain)));
    const std::string gzip(reinterpret_cast<const char*>(packed.data()), packed.size());
    return {
        "NRRD0004\n# scan\ntype: short\ndimension: 3\nsizes: 3 4 5\nspacings: 1.5 1.5 3\n"
        "units: \"mm\" \"mm\" \"mm\"\nendian: little\nencoding: gzip\n\n" +
            gzip,
        "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 3 4 5\nencoding: raw\nkey:=value\n\n" +
            stored_samples(stored_count),
        "NRRD0004\ntype: float\ndimension: 4\nspace: left-posterior-superior\nsizes: 3 1 4 5\n"
        "space directions: none (1,0,0) (0,-2,0) (0,0,3)\nspace origin: (1,2,3)\n"
        "kinds: vector domain domain domain\nmeasurement frame: (1,0,0) (0,1,0) (0,0,1)\n"
        "endian: big\nencoding: raw\n\n" +
            stored_samples(4 * stored_count)};
}

/// Headers whose samples are in another file.
std::vector<std::string> header_seeds(const Places& places) {
    (void)write_text_file(places.scratch / "s.raw", stored_samples(2 * stored_count));
    return {
        "NRRD0005\ntype: ushort\ndimension: 3\nsizes: 3 4 5\nspace: RAS\n"
        "space directions: (0.6,0.8,0) (-0.8,0.6,0) (0,0,-2)\nspace origin: (1.5,-2,3)\n"
        "space units: \"mm\" \"mm\" \"mm\"\nkinds: domain domain domain\nendian: big\n"
        "encoding: raw\nbyte skip: -1\ncontent: a name\ndata file: s.raw\n",
        "NRRD0003\ntype: uint8\ndimension: 3\nsizes: 4 5 6\nspacings: 1 1 1\nencoding: raw\n"
        "datafile: s.raw\n\n"};
}

std::vector<std::string> raw_seeds(const Places& places) {
    (void)write_text_file(places.scratch / "s.raw", stored_samples(2 * stored_count));
    return {
        "version = 1\nfile = \"s.raw\"\nsizes = [3, 4, 5]\ntype = \"int16\"\nendian = \"big\"\n"
        "spacing_mm = [1.9, 1.9, 3]\nname = \"head\"\nunits = \"HU\"\n"};
}

}  // namespace

const Reader nrrd_reader{"nrrd", nrrd_seeds, mutate_bytes, read_volume_file<nrrd>};
const Reader nhdr_reader{"nhdr", header_seeds, mutate_text, read_volume_file<nhdr>};
const Reader raw_volume_reader{"raw", raw_seeds, mutate_text, read_volume_file<toml>};

}  // namespace thaum::fuzz
