// Tests of volume files that cannot simply be read: samples that floats cannot distinguish, files from
// another computer, bytes of another encoding or order, other formats. Each is read correctly, or refused
// with the line and what to do.
#include <algorithm>
#include <cstring>

#include "core/one_line.h"
#include "field/volume_file.h"
#include "field/voxel_volume.h"
#include "unit/volume_files.h"

namespace thaum::field {
namespace {

template <class T>
std::string bytes_of(const std::vector<T>& values, bool big = false) {
    std::string out;
    for (const T value : values) {
        std::string one(sizeof(T), '\0');
        std::memcpy(one.data(), &value, sizeof(T));
        out += big ? std::string(one.rbegin(), one.rend()) : one;
    }
    return out;
}

std::string fields(std::string_view type, std::string_view sizes, std::string_view encoding = "raw") {
    return text("type: ", type, "\ndimension: 3\nsizes: ", sizes, "\nencoding: ", encoding,
                "\nendian: little");
}

TEST_F(VolumeFiles, SmallDifferencesOnALargeOffset) {
    const auto with = [&]<class T>(std::string_view type, std::vector<T> values) {
        return read(fields(type, "2 2 1"), bytes_of(values));
    };
    const auto kept =
        with("int", std::vector<std::int32_t>{1'000'000, 1'000'001, 1'000'002, 1'000'003}).value();
    EXPECT_EQ(kept.samples, (std::vector<float>{1'000'000, 1'000'001, 1'000'002, 1'000'003}));
    EXPECT_TRUE(kept.notes.empty());
    EXPECT_TRUE(with("double", std::vector<double>{0.1, 0.2, 0.3, 1000.7})->notes.empty());
    const auto coarse = with("double", std::vector<double>{1, 1 + 1e-6, 1 + 2e-6, 1 + 3e-6}).value();
    EXPECT_EQ(coarse.notes,
              std::vector<std::string>{"the samples, which differ by 3e-06 at most, are rounded to steps of "
                                       "1.19e-07; to keep all of them, subtract 1 from all samples"});
    const std::string same = "too coarse; subtract ";
    expect_refused(with("int", std::vector<std::int32_t>{100'000'000, 100'000'001, 100'000'002, 100'000'003}),
                   same + "1e+08 from all samples");
    expect_refused(
        with("longlong", std::vector<std::int64_t>{1LL << 62U, (1LL << 62U) + 1, 1LL << 62U, 1LL << 62U}),
        "differ by 1 at most");
    expect_refused(with("double", std::vector<double>{1e9 + 1, 1e9, 1e9 + 2, 1e9 + 3}), same);
    expect_refused(with("double", std::vector<double>{1e-300, 2e-300, 0, 0}), "multiply all samples");
    expect_refused(with("double", std::vector<double>{1e300, 2, 0, 0}),
                   "of its 4 samples, 1 is beyond 3.4e+38 in size");
    expect_refused(read(fields("double", "2 1 1", "ascii"), "1000000000.5 1000000000.75"), same);
    put("d.raw", bytes_of(std::vector<double>{1e9 + 1, 1e9}));
    expect_refused(read_volume(put("d.toml",
                                   "version = 1\nfile = \"d.raw\"\nsizes = [2, 1, 1]\ntype = \"double\"\n"
                                   "spacing_mm = [1, 1, 1]\n")),
                   same);
}

TEST_F(VolumeFiles, EqualAndHugeSamplesAreABody) {
    for (const double value : {1e9, -1e30, 3e38}) {
        const auto v = read(fields("double", "2 2 2"), bytes_of(std::vector<double>(8, value))).value();
        const auto body = voxels_of(v).value();
        EXPECT_GT(body.full, body.empty);
    }
    const auto wide = read(fields("float", "2 1 1"), bytes_of(std::vector<float>{-3e38F, 3e38F}));
    EXPECT_EQ(voxels_of(*wide)->surface, 0) << "the range itself is beyond a float";
}

TEST_F(VolumeFiles, FilesOfSamplesFromOtherComputers) {
    fs::create_directories(in_folder("sub/raw"));
    put("y.raw", shorts(24));
    put("Sub.raw", shorts(24));
    put("sub/raw/z.raw", shorts(24));
    const auto detached = [&](std::string_view name) {
        return read_nrrd(
            put("sub/d.nhdr", text("NRRD0004\n", fields("short", "2 3 4"), "\ndata file: ", name, "\n")));
    };
    for (const auto& [name, place] : {std::pair{"..\\y.raw", "y.raw"},
                                      {"../Y.RAW", "y.raw"},
                                      {"RAW\\Z.raw", "sub/raw/z.raw"},
                                      {"raw\\z.raw", "sub/raw/z.raw"},
                                      {".\\raw\\..\\raw\\z.RAW", "sub/raw/z.raw"}}) {
        const auto v = detached(name).value();
        EXPECT_EQ(v.samples[23], 23);
        EXPECT_EQ(v.notes,
                  std::vector<std::string>{text("there is no file '", printable(name, 200),
                                                "'; the samples are read from ", in_folder(place).string())});
        EXPECT_EQ(v.files[1].lexically_normal(), in_folder(place));
    }
    put("sub/w.raw", shorts(24));
    for (const char* name : {"C:\\Users\\x\\W.raw", "C:\\Users\\some one\\w.raw", "/elsewhere/w.raw",
                             "\\\\server\\w.raw", "\"w.raw\""}) {
        const auto v = detached(name).value();
        EXPECT_EQ(v.files[1], in_folder("sub/w.raw"));
        EXPECT_EQ(v.notes.size(), 1U);
    }
    put("sub/W.RAW", shorts(24));
    expect_refused(detached("C:\\W.raw"), "sub/d.nhdr:7: field 'data file': there is no file 'C:\\W.raw'");
    EXPECT_EQ(detached("C:\\w.raw")->files[1], in_folder("sub/w.raw")) << "the name itself comes first";
    expect_refused(detached("none.raw"), in_folder("sub/none.raw").string() + " was looked for");
    const auto listed = read_nrrd(put("sub/l.nhdr", text("NRRD0004\n", fields("short", "2 3 4"),
                                                         "\ndata file: LIST\nD:\\w.raw\nC:\\gone.raw\n")));
    expect_refused(listed, "sub/l.nhdr:9: field 'data file': there is no file 'C:\\gone.raw'");
    const auto raw =
        read_volume(put("sub/d.toml",
                        "version = 1\nfile = 'C:\\raw\\z.raw'\nsizes = [2, 3, 4]\ntype = \"int16\"\n"
                        "spacing_mm = [1, 1, 1]\n"));
    expect_refused(raw, "No such file");
    EXPECT_TRUE(read_volume(put("d.toml",
                                "version = 1\nfile = 'C:\\data\\Y.raw'\nsizes = [2, 3, 4]\ntype = \"int16\"\n"
                                "spacing_mm = [1, 1, 1]\n")));
}

TEST_F(VolumeFiles, BytesOfAnotherEncodingAreNamed) {
    const auto in = [&](std::string_view encoding, std::string_view data, std::string_view type = "short") {
        return read(fields(type, "2 3 4", encoding), data);
    };
    const std::string at = ":5: field 'encoding': the samples in the file are ";
    std::string numbers;
    for (int i = 0; i < 24; ++i) numbers += text(i, ' ');
    for (const char* encoding : {"raw", "ascii"})
        expect_refused(in(encoding, gzipped(shorts(24))), at + "gzip bytes; write 'encoding: gzip'");
    for (const char* encoding : {"raw", "gzip", "ascii"}) {
        for (const auto& [bytes, name] : {std::pair{"BZh91AY&SY", "bzip2"},
                                          {"PK\3\4xxxxxxxx", "zip"},
                                          {"\xfd"
                                           "7zXZxx",
                                           "xz"}})
            expect_refused(in(encoding, bytes), text(at, name, " bytes; unpack them"));
    }
    for (const char* encoding : {"raw", "gzip"})
        expect_refused(in(encoding, numbers), at + "numbers in text; write 'encoding: ascii'");
    for (const char* encoding : {"gzip", "ascii"})
        expect_refused(in(encoding, shorts(24)),
                       at + "as many plain bytes as the sizes and the type promise; write 'encoding: raw'");
    expect_refused(in("gzip", "?"), "are no gzip bytes");
    expect_refused(in("raw", shorts(24), "float"), "there are 2 for each sample, but 'type' has 4");
    const auto more = in("raw", shorts(24), "int8").value();
    EXPECT_EQ(more.notes,
              std::vector<std::string>{"what follows the samples is left out; there are 2 for each "
                                       "sample, but 'type' has 1"});
    std::string short_numbers = "x";
    for (int i = 0; i < 24; ++i) short_numbers += "1 ";
    EXPECT_TRUE(read(fields("short", "2 3 4", "ascii") + "\nbyte skip: 1", short_numbers))
        << "as many bytes as raw samples, but numbers in text";
    EXPECT_TRUE(in("raw", "\x78\x01" + shorts(24))) << "the first bytes of zlib, but plain samples";
    expect_refused(in("ascii", "1,5;2,5;1,5;2,5;1,5;2,5;1,5;2,5;1,5;2,5;1,5;2,5;"),
                   "'5;2' at place 2 is no number; write points");
    expect_refused(in("ascii", "1 2 3"), "promises 24 numbers of samples, but there are 3");
    const std::string line = "; the header seems to have an empty line too many";
    const auto displaced = in("raw", "\n" + shorts(24)).value();
    EXPECT_EQ(displaced.notes, std::vector<std::string>{"what follows the samples is left out" + line});
    expect_refused(in("gzip", "\r\n" + gzipped(shorts(24))), "no gzip bytes" + line);
    put("s.raw", shorts(24));
    const auto detached =
        read_nrrd(put("d.nhdr", text("NRRD0004\n", fields("int8", "2 3 4"), "\ndata file: s.raw\n"))).value();
    EXPECT_EQ(detached.notes, std::vector<std::string>{"s.raw: " + more.notes[0]});
    put("s.raw", gzipped(shorts(24)));
    expect_refused(
        read_nrrd(put("d.nhdr", text("NRRD0004\n", fields("short", "2 3 4"), "\ndata file: s.raw\n"))),
        "d.nhdr:5: field 'encoding': the samples in s.raw are gzip bytes");
}

TEST_F(VolumeFiles, TheOtherByteOrderIsTold) {
    std::vector<float> values(24);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.37F * static_cast<float>(i);
    expect_refused(read(fields("float", "2 3 4"), bytes_of(values, true)), "write 'endian: big'");
    EXPECT_TRUE(read(fields("float", "2 3 4"), bytes_of(values)));
    std::vector<std::int16_t> bytes(24);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::int16_t>(i);
    const auto shorts_swapped = read(fields("short", "2 3 4"), bytes_of(bytes, true)).value();
    EXPECT_EQ(
        shorts_swapped.notes,
        std::vector<std::string>{"every sample is a multiple of 256; if that is wrong, write 'endian: big'"});
    for (float& value : values) value = 1e-35F;
    EXPECT_TRUE(read(fields("float", "2 3 4"), bytes_of(values))) << "small, but absurd in both orders";
}

TEST_F(VolumeFiles, FaultsOfHeadersHaveTheirLine) {
    const auto faulty = [&](std::string_view lines, std::string_view what) {
        expect_refused(read(lines, shorts(24)), what);
    };
    const auto good = fields("short", "2 3 4");
    faulty("type: short\ndimension: 3\nencoding: raw\nendian: big",
           ":6: the header, which ends here, has no field 'sizes'");
    faulty(good + "\n \t", ":7: a line of blanks");
    faulty(good + "\nspace: LPS\nspace directions: (1,0,0) (0.2,1,0) (0,0,1)",
           ":8: field 'space directions': the axes are not at right angles");
    faulty(good + "\nspacings: 0,5 0,5 1,0", ":7: field 'spacings': '0,5' is no number; write a point");
    faulty(good + "\nspace orgin: (0,0,0)",
           ":7: NRRD has no field 'space orgin'; did you mean 'space origin'?");
    faulty(good + "\npatient: x",
           ":7: NRRD has no field 'patient'; a key of your own is written 'patient:=value'");
    expect_refused(read_nrrd(put("v.nrrd", "NRRD0009\n\n")), "v.nrrd:1: a version of NRRD");
    EXPECT_TRUE(read_nrrd(put("v.nrrd", text("\xef\xbb\xbfNRRD0004\n", good, "\n\n", shorts(24)))))
        << "a byte order mark";
    auto with_returns = text("NRRD0004\n", good, "\n\n");
    std::ranges::replace(with_returns, '\n', '\r');
    const auto old = read_nrrd(put("v.nrrd", with_returns + shorts(24))).value();
    EXPECT_EQ(old.samples[23], 23);
}

TEST_F(VolumeFiles, OtherFormatsAreNamed) {
    for (const auto& [file, name] : {std::pair{"v.mha", "MetaImage files are not read"},
                                     {"v.NII.gz", "NIfTI"},
                                     {"v.nrrd.gz", "packed files"},
                                     {"v.tif", "Fiji"},
                                     {"v.raw", "describe them in a .toml or .nhdr, and open that"}})
        expect_refused(read_volume(in_folder(file)), name);
}

}  // namespace
}  // namespace thaum::field
