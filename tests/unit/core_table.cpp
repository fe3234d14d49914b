// Tests of tables as programs and spreadsheets write them: what makes no difference, and how faults are
// reported.
#include "core/table.h"

#include <gtest/gtest.h>

#include "core/text.h"

namespace thaum {
namespace {

/// All cells of the columns t and x of a table, each with its line; or the error.
std::string read(std::string_view csv, std::string_view usual_titles = {}) {
    TableReader table(csv, "f", usual_titles);
    const auto t = table.column("t"), x = table.column("x");
    std::string out;
    while (table.next()) append_text(out, text(table.number(t), " ", table.cell(x), "\n"));
    return table.good() ? out : table.fault().message;
}

TEST(Table, WhatSpreadsheetsWriteIsRead) {
    const std::string right = "0.5 a\n-2 b c\n";
    for (const char* csv : {
             "t,x\n0.5,a\n-2,b c\n",
             "t,x\n0.5,a\n-2,b c",
             "\xef\xbb\xbft,x\r\n0.5,a\r\n-2,b c\r\n",
             "t,x\r0.5,a\r-2,b c\r",
             "\"t\",\"x\"\n\"0.5\",\"a\"\n-2,\"b c\"\n",
             " t , x \n 0.5 , a \n -2 ,\"b c\" \n",
             "\n\nt,x\n\n0.5,a\n,\n-2,b c\n,,,\n",
             "t,x,,\n0.5,a,,\n-2,b c,,,\n",
             "x,t\na,+0.5\nb c,-2E0\n",
             "t;x\n0.5;a\n-2;b c\n",
             "t;x\n0,5;a\n-2,0;b c\n",
             "t\tx\r\n\"0,5\"\ta\r\n-2\tb c\r\n",
             "sep=;\r\nt;x\r\n0,5;a\r\n-2;b c\r\n",
             "sep=|\nt|x\n0.5|a\n-2|b c\n",
             "\"t\";\"x\";\"1,2\"\n0.5;a;\n-2;b c;\n",
             "also,t,x,also\n?,0.5,a,?\n?,-2,b c,?\n",
             "T,X\n0.5,a\n-2,b c\n",
             "t;x;note, remark\n0,5;a;\n-2;b c;\n",
         })
        EXPECT_EQ(read(csv), right) << csv;
    EXPECT_EQ(read("0.5,a\n-2,b c\n", "t,x"), right);
    EXPECT_EQ(read("0,5;a\n-2;b c\n", "t,x"), right);
    EXPECT_EQ(read("t,x\n0.5,a\n-2,b c\n", "t,x"), right);
}

TEST(Table, ACellInQuotesIsTakenAsItIs) {
    EXPECT_EQ(read("t,x\n1,\" a, \"\"b\"\";\nc \"\n2,\"\"\n3,5\" wide\n"),
              "1  a, \"b\";\nc \n2 \n3 5\" wide\n");
    for (const auto* cell : {"plain", "a,b", "a;b", "say \"hi\"", "two\nlines", "", " blank", "\""}) {
        std::string row = "t,x\n1,";
        append_cell(row, cell);
        EXPECT_EQ(read(row), text("1 ", cell, "\n"));
    }
    std::string plain;
    append_cell(plain, "b c");
    EXPECT_EQ(plain, "b c");
}

TEST(Table, FaultsNameTheLineInWhichTheRowBegins) {
    EXPECT_EQ(read(""), "f:1: the file is empty");
    EXPECT_EQ(read("\n , \n"), "f:2: the file is empty");
    EXPECT_EQ(read("\xff\xfet\0,\0x\0"), "f:1: this is UTF-16; save the table as CSV in UTF-8");
    EXPECT_EQ(read("u,x\n1,2\n"), "f:1: no column 't'; there are: u, x");
    EXPECT_EQ(read("t,x,t\n1,2,3\n"), "f:1: two columns have the title 't'");
    EXPECT_EQ(read("t,x\n1,2,3\n"), "f:2: the number of cells is 3, that of titles 2");
    EXPECT_EQ(read("t,x\n1,2\n3\n"), "f:3: the number of cells is 1, that of titles 2");
    EXPECT_EQ(read("t,x\n1,\"2\n3\"\n,4\n"), "f:4: no number in the column 't'");
    EXPECT_EQ(read("t,x\n1,\"2\n3\n"), "f:2: a quote is opened and not closed");
    EXPECT_EQ(read("t,x\n1,\"2\"3\n"), "f:2: text behind a closing quote");
    for (const char* word : {"one", "1.5.2", "nan", "inf", "1e999", "0x10", "++1", "+-1", "1 2"})
        EXPECT_EQ(read(text("t,x\n", word, ",2\n")),
                  text("f:2: '", word, "' in the column 't' is not a finite number"));
    EXPECT_EQ(read("t;x\n1,5,5;2\n"), "f:2: '1,5,5' in the column 't' is not a finite number");
    EXPECT_EQ(read("t,x\n\"0,5\",2\n"),
              "f:2: '0,5' in the column 't' is not a finite number; write a point for the comma");
    EXPECT_EQ(read("t;x\n0,5;a\n1.234;b\n"),
              "f:3: '1.234' has another sign for the point than the numbers before it");
    EXPECT_EQ(read("T,x,t\n1,2,3\n"), "f:1: two columns have the title 't'");
    EXPECT_EQ(read("PK\x03\x04..."), "f:1: this is a workbook or an archive; save the table as CSV in UTF-8");
    EXPECT_EQ(read(text("t,x\n", std::string(1000, ','), "\n")), "f:2: more than 1000 columns");
}

TEST(Table, TheFirstFaultCountsAndEndsTheRows) {
    TableReader table("t\none\ntwo\n3\n", "f");
    ASSERT_TRUE(table.next());
    EXPECT_EQ(table.number(0), 0);
    EXPECT_EQ(table.number(TableReader::no_column), 0);
    table.report("another");
    EXPECT_FALSE(table.next());
    EXPECT_EQ(table.fault().message, "f:2: 'one' in the column 't' is not a finite number");
}

}  // namespace
}  // namespace thaum
