#include "catch_shim.hpp"
#include "reading.hpp"
#include "spec/text_check.hpp"

using test::Read;

TEST_CASE("a duplicate key is refused at its second place") {
  const Read read("m: 1\nk: 2\nm: 3\n");
  CHECK(read.code() == "E006");
  CHECK(read.place().line == 3);
  CHECK(read.diagnostics.all()[0].message.find("line 1") != std::string::npos);
}

TEST_CASE("the first of two equal keys is kept, so that reading can go on") {
  CHECK(Read("m: 1\nm: 3\n").at("m").scalar.text == "1");
}

TEST_CASE("an alias to what holds it ends with an error and not in a loop") {
  const Read read("a: &a [*a]\n");
  CHECK(read.code() == "E007");
  CHECK_FALSE(read.root);
}

TEST_CASE("anchors and tags are refused at their sign") {
  const Read anchor("a: &b 1\n");
  CHECK(anchor.code() == "E007");
  CHECK(anchor.place().column == 4);
  const Read tag("a: !!int 1\n");
  CHECK(tag.code() == "E007");
  CHECK(tag.place().column == 4);
}

TEST_CASE("a second document is refused") {
  CHECK(Read("a: 1\n---\nb: 2\n").code() == "E008");
  CHECK(Read("a: 1\n...\n").root);
}

TEST_CASE("a file that ends inside quotes is refused at the quote") {
  CHECK(Read("a: \"x\n").code() == "E004");
  CHECK(Read("a: \"x\n").place().column == 4);
  CHECK(Read("a: 'it''s\n").code() == "E004");
}

TEST_CASE("nesting beyond the limit is refused without a crash") {
  CHECK(Read("a: " + std::string(31, '[') + std::string(31, ']')).root);
  CHECK(Read("a: " + std::string(32, '[') + std::string(32, ']')).code() == "E003");
  CHECK_FALSE(Read("a: " + std::string(100'000, '[')).root);
  CHECK_FALSE(Read("a: " + std::string(100'000, '{')).root);
  CHECK_FALSE(Read("a: " + std::string(100'000, '[') + std::string(100'000, ']')).root);
}

TEST_CASE("too many values and too large files are refused") {
  std::string list = "a: [";
  for (int i = 0; i <= gaussgen::spec::k_most_nodes; ++i) list += "1,";
  CHECK(Read(list + "1]\n").code() == "E003");
  CHECK(Read("a: " + std::string(gaussgen::spec::k_largest_file, 'x')).code() == "E003");
}

TEST_CASE("wide encodings are refused, with a mark and without") {
  CHECK(Read(std::string("\xFF\xFE"
                         "a\0:\0",
                         6))
            .code() == "E001");
  CHECK(Read(std::string("\xFE\xFF\0a\0:", 6)).code() == "E001");
  CHECK(Read(std::string("a\0:\0 \0", 6)).code() == "E001");
  CHECK(Read(std::string("\0\0\xFE\xFF\0\0\0a", 8)).code() == "E001");
}

TEST_CASE("a forbidden character is refused also where it is only escaped") {
  CHECK(Read("a: \"\\x1b\"\n").code() == "E002");
  CHECK(Read("a: \"\\u202e\"\n").code() == "E002");
  CHECK(Read("a: \"\\0\"\n").code() == "E002");
  CHECK(Read("a: 1 # \xE2\x80\xAE\n").code() == "E002");
}

TEST_CASE("a tab in the indentation is named as such") {
  CHECK(Read("a:\n\tb: 1\n").code() == "E005");
  CHECK(Read("a: [1,\n\t2]\n").root);
}

TEST_CASE("an old Mac line end is refused") { CHECK_FALSE(Read("a: 1\rb: 2\r").diagnostics.all().empty()); }

TEST_CASE("an empty text is refused") {
  CHECK(Read("").code() == "E009");
  CHECK(Read("# words\n").code() == "E009");
  CHECK(Read("---\n").code() == "E009");
}

TEST_CASE("what is wrong at the end of the text is said there, and not behind it") {
  for (const char* const text : {"  \": \n\\", "a: \"b\\", "a: \"\\x", "a: 'b", "a: [1"}) {
    const Read read(text);
    REQUIRE_FALSE(read.diagnostics.all().empty());
    CHECK(read.diagnostics.all()[0].span.begin <= read.source.text().size());
  }
}
