// node embed.mjs PAGE OUTPUT.cpp: the page as C++. Compilers take string literals of 64 kB for sure, and no more (C++ [implimits]), so the
// text is in pieces, which are put together when it is first asked for.

import {readFileSync, writeFileSync} from 'node:fs';

const k_piece = 8000;  // bytes: with its escapes below 16 kB, which is what some compilers take
const k_line = 160;

const [input, output] = process.argv.slice(2);
const bytes = readFileSync(input);

/** Octal escapes end after three digits, whatever follows. */
function escaped(byte) {
  if (byte === 0x22 || byte === 0x5c) return `\\${String.fromCharCode(byte)}`;
  if (byte === 0x0a) return '\\n';
  return byte >= 0x20 && byte < 0x7f && byte !== 0x3f ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, '0')}`;
}

function literal(piece) {
  const lines = [];
  for (let at = 0; at < piece.length; at += k_line) lines.push(`"${[...piece.subarray(at, at + k_line)].map(escaped).join('')}"`);
  return lines.join('\n    ');
}

const pieces = [];
for (let at = 0; at < bytes.length; at += k_piece) pieces.push(bytes.subarray(at, at + k_piece));

writeFileSync(output, `// Made by embed.mjs.
#include "sim/report/report_template.hpp"

#include <string>

namespace gausssim {

namespace {

constexpr std::string_view k_pieces[] = {
    ${pieces.map((piece) => `{${literal(piece)}, ${piece.length}}`).join(',\n    ')}};

std::string joined() {
  std::string text;
  text.reserve(${bytes.length});
  for (const std::string_view piece : k_pieces) text += piece;
  return text;
}

}  // namespace

std::string_view report_template() {
  static const std::string text = joined();
  return text;
}

}  // namespace gausssim
`);
