// Tests of NRRD files as they occur in practice: colours, time, missing values, unusual units, bytes after
// the samples, skipped bytes, several files, large integers, long headers.
#include <algorithm>

#include "field/volume_file.h"
#include "unit/volume_files.h"

namespace thaum::field {
namespace {

TEST_F(VolumeFiles, OfColoursTheLuminanceIsRead) {
    const char* start =
        "NRRD0005\ntype: uint8\ndimension: 4\nencoding: raw\nsizes: 3 2 1 1\n"
        "space directions: none (0,1,0) (-1,0,0) (0,0,1)\nspace: RAS\nkinds: ";
    const std::string_view data("\xff\x00\x00\x0a\x14\x1e", 6);
    const auto read_as = [&](std::string_view kind, const ReadChoice& choice) {
        return read_nrrd(put("v.nrrd", text(start, kind, " domain domain domain\n\n", data)), choice).value();
    };
    const auto seen = read_as("RGB-color", {});
    EXPECT_EQ(seen.components, 1);
    EXPECT_EQ(seen.stored_as, SampleType::float32);
    ASSERT_EQ(seen.samples.size(), 2U);
    EXPECT_NEAR(std::max(seen.samples[0], seen.samples[1]), 0.2126 * 255, 1e-5);
    EXPECT_NEAR(std::min(seen.samples[0], seen.samples[1]), 0.2126 * 10 + 0.7152 * 20 + 0.0722 * 30, 1e-5);
    EXPECT_EQ(seen.notes.size(), 1U);
    EXPECT_EQ(read_as("HSV-color", {}).samples, (std::vector<float>{30, 0})) << "the value";
    EXPECT_EQ(read_as("XYZ-color", {}).samples, (std::vector<float>{20, 0})) << "Y is the luminance";
    const auto colours = read_as("RGB-color", {.colours_as_vectors = true});
    EXPECT_EQ(colours.samples, (std::vector<float>{10, 20, 30, 255, 0, 0})) << "colours do not turn";
    ASSERT_TRUE(write_nrrd(in_folder("again.nrrd"), colours));
    EXPECT_EQ(read_nrrd(in_folder("again.nrrd"))->components, 1) << "a file of colours says so";
    EXPECT_EQ(read_nrrd(in_folder("again.nrrd"), {.colours_as_vectors = true})->samples, colours.samples);
    expect_refused(read_nrrd(put("v.nrrd", text(start, "HSV-color domain domain domain\n\n", data)),
                             {.colours_as_vectors = true}),
                   ":8: field 'kinds': colours must be red, green and blue");
}

TEST_F(VolumeFiles, OneMomentOfTimeIsRead) {
    const std::string head =
        "NRRD0005\ntype: short\ndimension: 4\nendian: little\nencoding: raw\nsizes: 3 2 2 1\n"
        "kinds: time domain domain domain\n\n";
    const auto path = put("v.nrrd", head + shorts(12));
    const auto last = read_nrrd(path, {.frame = 2}).value();
    EXPECT_EQ(last.samples, (std::vector<float>{2, 5, 8, 11}));
    EXPECT_EQ(last.frames, 3);
    EXPECT_EQ(last.notes, std::vector<std::string>{"moment 3 of 3 is read"});
    expect_refused(read_nrrd(path, {.frame = 3}), "there is no moment 4; the file has 3");
    expect_refused(read_nrrd(path, {.frame = -1}), "there is no moment 0");
}

TEST_F(VolumeFiles, AxesOfOtherKindsAreRefusedByName) {
    for (const char* kind :
         {"list", "2-vector", "quaternion", "3D-symmetric-matrix", "complex", "nonsense"}) {
        expect_refused(read(text("type: uint8\ndimension: 4\nencoding: raw\nsizes: 4 2 2 2\nkinds: ", kind,
                                 " domain domain domain"),
                            std::string(32, 'x')),
                       text("an axis of the kind '", kind, "' cannot be read"));
        const auto one = read(text("type: uint8\ndimension: 4\nencoding: raw\nsizes: 1 2 2 2\nkinds: ", kind,
                                   " domain domain domain"),
                              std::string(8, 'x'));
        EXPECT_TRUE(one) << "one entry of any kind is a scalar";
    }
    expect_refused(read("type: uint8\ndimension: 4\nencoding: raw\nsizes: 7 2 2 2", std::string(56, 'x')),
                   "'kinds' does not tell what the 7 samples of axis 0 are");
}

TEST_F(VolumeFiles, OfNumbersInWordsEachChangeIsTold) {
    const auto read_ascii = [&](std::string_view type, std::string_view numbers) {
        return read(text("type: ", type, "\ndimension: 3\nsizes: 2 2 1\nencoding: ascii"), numbers);
    };
    const auto cut = read_ascii("short", "1 2.7 40000 -40000\n").value();
    EXPECT_EQ(cut.samples, (std::vector<float>{1, 2, 32767, -32768}));
    EXPECT_EQ(cut.notes, std::vector<std::string>{
                             "samples such as 2.7 are no numbers of the type 'int16', and are made so"});
    const auto right = read_ascii("short", "1, 2, 3, -4\n").value();
    EXPECT_TRUE(right.notes.empty());
    expect_refused(read_ascii("float", "100,5 107,5 1,5 2,5\n"), "numbers have points, not commas");
}

TEST_F(VolumeFiles, SamplesOfAnUntoldKindAreColoursOrAVectorWithALine) {
    const auto with = [&](std::string_view type, std::string_view sizes, std::string_view more,
                          std::size_t bytes) {
        return read(text("type: ", type, "\ndimension: 4\nencoding: raw\nendian: little\nsizes: ", sizes,
                         more),
                    std::string(bytes, '\1'))
            .value();
    };
    const auto colour = with("uint8", "3 2 2 2", "", 24);
    EXPECT_EQ(colour.components, 1) << "bytes have no sign, so they are colours";
    EXPECT_EQ(colour.notes,
              std::vector<std::string>{
                  "'kinds' does not tell what the 3 samples of axis 0 are; they are taken as red, green and "
                  "blue, of which the luminance is read; for a vector write 'kinds: vector domain domain "
                  "domain'"});
    EXPECT_EQ(with("uint8", "4 2 2 2", "\nkinds: ??? domain domain domain", 32).notes.size(), 1U);
    const auto vector =
        with("short", "2 2 2 3", "\nspace: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1) none", 48);
    EXPECT_EQ(vector.components, 3);
    ASSERT_EQ(vector.notes.size(), 1U);
    EXPECT_TRUE(vector.notes[0].ends_with("for colours write 'kinds: domain domain domain RGB-color'"));
    const auto last = with("uint8", "2 2 2 3", "\nspacings: 1 1 1 nan", 24);
    EXPECT_EQ(last.count, (std::array{2, 2, 2}));
    EXPECT_NE(last.notes.at(0).find("the 3 samples of axis 3"), std::string::npos);
    const auto told = with("uint8", "3 2 2 2", "\nkinds: vector domain domain domain", 24);
    EXPECT_EQ(told.components, 3);
    EXPECT_TRUE(told.notes.empty());
}

TEST_F(VolumeFiles, WhatIsNotGivenIsLikeMissing) {
    const char* space = "space: left-posterior-superior\n";
    for (const char* place :
         {"space directions: (1,0,0) (0,1,0) (0,0,2)\nspace origin: (10,20,30)\nspacings: nan NaN none",
          "space directions: none none none\nspacings: 1 1 2\nspace origin: (10,20,30)",
          "space directions: (nan,nan,nan) none none\nspacings: 1 1 2\nspace origin: (10,20,30)",
          "spacings: 1 1 2\nspace origin: (10,20,30)",
          "spacings: nan nan nan\naxis mins: 0 0 0\naxis maxs: 2 3 8\nspace origin: (10,20,30)"}) {
        const auto v = read_short(text(space, place));
        EXPECT_EQ(v.spacing, vec3(1, 1, 2) / 1000.0) << place;
        ASSERT_TRUE(v.file_axes && v.file_axes->first) << place;
        EXPECT_EQ(*v.file_axes->first, vec3(10, 20, 30) / 1000.0) << place;
    }
    EXPECT_EQ(read_short("spacings: nan 1 2").spacing, vec3(1, 1, 2) / 1000.0);
    EXPECT_FALSE(read_short("space dimension: 3\nspacings: 1 1 1\nspace origin: none").has_place);
    // If only spacings are given, the samples lie along the axes of the space, even if that space is turned.
    EXPECT_EQ(*read_short("space: RAS\nspacings: 1 1 1\nspace origin: (1,2,3)").file_axes->first,
              vec3(-1 - 1, -2 - 2, 3) / 1000.0);
}

TEST_F(VolumeFiles, UnitsOfTheWild) {
    const std::string dirs = "space dimension: 3\nspace directions: (1,0,0) (0,1,0) (0,0,2)\nspace units: ";
    const auto metres = [&](std::string_view unit) {
        const auto v = read_short(text(dirs, '"', unit, "\" \"", unit, "\" \"", unit, '"'));
        EXPECT_EQ(v.notes.size(), unit == "pixel" || unit == "mm m" ? 1U : 0U) << unit;
        return v.spacing.x;
    };
    for (const char* unit : {"mm", "MM", "millimetre", "Millimeters", "", "???", "pixel", "mm m"})
        EXPECT_EQ(metres(unit), 0.001) << unit;
    for (const char* unit : {"um", "\xc2\xb5m", "\xce\xbcm", "\xb5m", "micron", "Micrometres"})
        EXPECT_EQ(metres(unit), 1e-6) << unit;
    EXPECT_EQ(metres("metre"), 1);
    EXPECT_EQ(metres("Centimetre"), 0.01);
    EXPECT_NEAR(metres("inches"), 0.0254, 1e-15);
}

TEST_F(VolumeFiles, BytesBehindTheSamplesAreLeftAndTold) {
    const std::string head = "type: short\ndimension: 3\nsizes: 2 3 4\nendian: little\nencoding: ";
    for (const auto& [encoding, data] :
         {std::pair{"raw", shorts(24) + "\n"},
          {"gzip", gzipped(shorts(24) + "\n")},
          {"gzip", gzipped(shorts(24)) + "\n"},
          {"gzip", gzipped(shorts(24)) + std::string(100, '\0')},
          {"gzip", gzipped(shorts(12)) + gzipped(shorts(24).substr(24) + "tail")},
          {"ascii", text("0 1 2 3 4 5 6 7 8 9 10 11,12, 13 +14 15\r\n16 17 18 19 20 21 22 23\n end")}}) {
        const auto v = read(head + encoding, data).value();
        for (int i = 0; i < 24; ++i) EXPECT_EQ(v.samples[static_cast<std::size_t>(i)], static_cast<float>(i));
        ASSERT_EQ(v.notes.size(), 1U) << encoding;
        EXPECT_NE(v.notes[0].find("what follows the samples is left out"), std::string::npos);
    }
}

TEST_F(VolumeFiles, SkipsInEveryEncoding) {
    const std::string head = "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\n";
    std::string numbers;
    for (int i = 0; i < 24; ++i) numbers += text(i, ' ');
    put("d.raw", "one\ntwo\nxy" + shorts(24));
    put("d.gz", "one\ntwo\n" + gzipped("xy" + shorts(24)));
    put("d.txt", "one\ntwo\nxy" + numbers);
    for (const auto& [encoding, file] : {std::pair{"raw", "d.raw"}, {"gzip", "d.gz"}, {"ascii", "d.txt"}}) {
        const auto fields = text(head, "encoding: ", encoding, "\nline skip: 2\nbyte skip: 2\n");
        const auto content = read_text_file(in_folder(file), 10'000).value();
        for (const auto& path : {put("d.nhdr", text(fields, "data file: ", file, "\n")),
                                 put("a.nrrd", text(fields, "\n", content))}) {
            const auto v = read_nrrd(path).value();
            for (int i = 0; i < 24; ++i)
                EXPECT_EQ(v.samples[static_cast<std::size_t>(i)], static_cast<float>(i));
        }
    }
    const auto last =
        read("type: short\ndimension: 3\nsizes: 2 3 4\nendian: little\nencoding: gzip\nbyte skip: -1",
             gzipped("something" + shorts(24)))
            .value();
    EXPECT_EQ(last.samples[23], 23);
}

TEST_F(VolumeFiles, SamplesInSeveralFiles) {
    const std::string head =
        "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\nencoding: raw\n";
    for (std::size_t k = 0; k < 4; ++k) {
        put(text("s", k, ".raw"), shorts(24).substr(12 * k, 12));
        put(text("t-", k == 3 ? "" : "0", k + 7, ".raw"), shorts(24).substr(12 * (3 - k), 12));
    }
    for (const char* files :
         {"LIST\ns0.raw\ns1.raw\ns2.raw\ns3.raw\n", "LIST 2\ns0.raw\r\n\ns1.raw\n s2.raw\ns3.raw",
          "s%d.raw 0 3 1", "s%1i.raw 0 3 1 2", "t-%02d.raw 10 7 -1\n"}) {
        const bool cut = std::string_view(files).find("\n\n") != std::string_view::npos;
        const auto v = read_nrrd(put("d.nhdr", text(head, "data file: ", files)));
        if (cut) continue;
        ASSERT_TRUE(v) << files << v.error().message;
        for (int i = 0; i < 24; ++i)
            EXPECT_EQ(v->samples[static_cast<std::size_t>(i)], static_cast<float>(i)) << files;
        EXPECT_EQ(v->files.size(), 5U);
        EXPECT_TRUE(v->notes.empty()) << v->notes[0];
    }
    expect_refused(read_nrrd(put("d.nhdr", head + "data file: LIST\ns0.raw\ns1.raw\n")), "promises 24 bytes");
    expect_refused(read_nrrd(put("d.nhdr", head + "data file: s%d.raw 0 4 1\n")), "5 equal files");
    for (const char* pattern : {"s%d.raw 0 3 0", "s%d.raw 0 3 -1", "s%x.raw 0 3 1", "s%d.raw 0 3",
                                "s%9999d.raw 0 3 1", "s%d%d.raw 0 3 1", "s%d.raw 0 1e99 1"})
        expect_refused(read_nrrd(put("d.nhdr", text(head, "data file: ", pattern, "\n"))),
                       "a pattern of files");
    expect_refused(read_nrrd(put("d.nhdr", head + "data file: s%d.raw 0 1000000 1\n")),
                   "more than 100000 files");
}

TEST_F(VolumeFiles, AFileWhoseNameBeginsWithListIsNoList) {
    put("LISTING.raw", shorts(24));
    const auto v = read_nrrd(put("d.nhdr",
                                 "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\n"
                                 "data file: LISTING.raw\nencoding: raw\n"))
                       .value();
    EXPECT_EQ(v.samples[23], 23);
}

TEST_F(VolumeFiles, AFileOfSamplesElsewhereIsTold) {
    fs::create_directory(in_folder("below"));
    put("d.raw", shorts(24));
    const std::string head =
        "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\nencoding: raw\n";
    for (const auto& file :
         {std::string("../d.raw"), std::string("./x/../../d.raw"), in_folder("d.raw").string()}) {
        fs::create_directories(in_folder("below/x"));
        const auto v = read_nrrd(put("below/d.nhdr", text(head, "data file: ", file, "\n"))).value();
        EXPECT_EQ(v.notes,
                  std::vector<std::string>{text("the samples are read from ", in_folder("d.raw").string())});
    }
}

TEST_F(VolumeFiles, LargeIntegersAreReadAndRoundingIsTold) {
    const std::string head = "dimension: 3\nsizes: 2 1 1\nendian: big\nencoding: raw\ntype: ";
    const auto small = read(head + "int", std::string_view("\xff\xff\xff\xfe\x00\x00\x00\xfa", 8)).value();
    EXPECT_EQ(small.samples, (std::vector<float>{-2, 250}));
    EXPECT_TRUE(small.notes.empty());
    const auto large = read(head + "unsigned long long", std::string(16, '\xff')).value();
    EXPECT_EQ(large.samples[0], 0x1p64F);
    EXPECT_EQ(large.notes, std::vector<std::string>{"integers beyond 16,777,216 are rounded"});
    const auto written = write_nrrd(in_folder("a.nrrd"), large);
    ASSERT_TRUE(written) << written.error().message;
    EXPECT_EQ(read_nrrd(in_folder("a.nrrd"))->samples, large.samples);
    EXPECT_EQ(read("type: uint8\ndimension: 3\nsizes: 2 1 1\nencoding: text", " 3.7 nan")->samples[0], 3);
    expect_refused(read("type: uint8\ndimension: 3\nsizes: 3 1 1\nencoding: txt", "1 two 3"),
                   "'two' at place 2 is no number");
    expect_refused(read("type: uint8\ndimension: 3\nsizes: 3 1 1\nencoding: ascii", "1 2  "), "there are 2");
    expect_refused(read("type: uint8\ndimension: 3\nsizes: 99999 1 1\nencoding: ascii", "1 2  "),
                   "promises 99999");
}

TEST_F(VolumeFiles, LongHeadersAndAnyCaseOfEndings) {
    const std::string head =
        "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\nencoding: raw\n";
    const std::string pairs = text("Segment0_Tags:=", std::string(1'000'000, 'x'), '\n');
    EXPECT_TRUE(read_volume(put("v.NRRD", text(head, pairs, "labels: \"x\" \"y\" \"z\"\n\n", shorts(24)))));
    EXPECT_EQ(read_volume(in_folder("v.NRRD"))->notes,
              std::vector<std::string>{"these fields of the header have no effect: labels"});
}

}  // namespace
}  // namespace thaum::field
